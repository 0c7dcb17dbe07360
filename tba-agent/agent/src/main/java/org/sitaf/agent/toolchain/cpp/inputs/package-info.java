/** Which files a compiler has read, and whether it would read the same ones now. */
@NullMarked
package org.sitaf.agent.toolchain.cpp.inputs;

import org.jspecify.annotations.NullMarked;
