/** Processes of test applications that wait for a debugger. */
@NullMarked
package org.sitaf.agent.toolchain.debug;

import org.jspecify.annotations.NullMarked;
