/** The C++ toolchain: the system's compiler in the sandbox, and a runtime that is compiled once. */
@NullMarked
package org.sitaf.agent.toolchain.cpp;

import org.jspecify.annotations.NullMarked;
