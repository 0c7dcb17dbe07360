/** How C++ spells what a test application holds: names, types, literals, calls, comments. */
@NullMarked
package org.sitaf.core.harness.cpp.spelling;

import org.jspecify.annotations.NullMarked;
