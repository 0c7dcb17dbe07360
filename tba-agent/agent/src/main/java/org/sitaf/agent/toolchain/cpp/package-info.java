/** C++: the system's compiler in the sandbox, a runtime that is compiled once and kept. */
@NullMarked
package org.sitaf.agent.toolchain.cpp;

import org.jspecify.annotations.NullMarked;
