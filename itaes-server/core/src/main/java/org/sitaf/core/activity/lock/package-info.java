/** The file that keeps the packages of an activity at exact releases. */
@NullMarked
package org.sitaf.core.activity.lock;

import org.jspecify.annotations.NullMarked;
