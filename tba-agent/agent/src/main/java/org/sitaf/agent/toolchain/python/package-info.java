/** Compiles Python test applications, and keeps an environment for each set of packages. */
@NullMarked
package org.sitaf.agent.toolchain.python;

import org.jspecify.annotations.NullMarked;
