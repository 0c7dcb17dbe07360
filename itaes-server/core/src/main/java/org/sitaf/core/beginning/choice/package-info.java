/** Chooses the interface of a new activity, and the files that it needs. */
@NullMarked
package org.sitaf.core.beginning.choice;

import org.jspecify.annotations.NullMarked;
