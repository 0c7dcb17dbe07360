/** Builds C++ components with their own CMake projects. */
@NullMarked
package org.sitaf.agent.toolchain.cpp.cmake;

import org.jspecify.annotations.NullMarked;
