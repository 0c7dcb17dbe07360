/** Base of the generated test applications, and the robot API of components under test. */
@NullMarked
package org.sitaf.runtime;

import org.jspecify.annotations.NullMarked;
