/** The C++ syntax of names, types, literals, calls and comments. */
@NullMarked
package org.sitaf.core.harness.cpp.syntax;

import org.jspecify.annotations.NullMarked;
