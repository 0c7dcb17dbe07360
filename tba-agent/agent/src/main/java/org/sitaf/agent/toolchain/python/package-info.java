/** The Python toolchain: byte code compilation, and one cached environment per set of packages. */
@NullMarked
package org.sitaf.agent.toolchain.python;

import org.jspecify.annotations.NullMarked;
