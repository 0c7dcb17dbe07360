/** What this machine can compile and run, by language. */
@NullMarked
package org.sitaf.agent.toolchain;

import org.jspecify.annotations.NullMarked;
