/** Compares the recorded behaviour of two versions of a component, without expected values. */
@NullMarked
package org.sitaf.core.compare;

import org.jspecify.annotations.NullMarked;
