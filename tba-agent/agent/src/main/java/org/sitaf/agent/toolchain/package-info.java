/** The compilers and interpreters of this machine, by language. */
@NullMarked
package org.sitaf.agent.toolchain;

import org.jspecify.annotations.NullMarked;
