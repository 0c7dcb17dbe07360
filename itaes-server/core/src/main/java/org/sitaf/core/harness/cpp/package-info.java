/** Generates test applications in C++: typed views decide, templates print. */
@NullMarked
package org.sitaf.core.harness.cpp;

import org.jspecify.annotations.NullMarked;
