/** Test applications in C++. */
@NullMarked
package org.sitaf.core.harness.cpp;

import org.jspecify.annotations.NullMarked;
