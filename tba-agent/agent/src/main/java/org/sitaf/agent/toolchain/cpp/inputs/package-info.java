/** The files that a compiler read, and whether it would read the same ones now. */
@NullMarked
package org.sitaf.agent.toolchain.cpp.inputs;

import org.jspecify.annotations.NullMarked;
