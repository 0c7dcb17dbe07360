/** Which system calls a confined process may not make, as a program for the kernel's filter. */
@NullMarked
package org.sitaf.agent.sandbox.seccomp;

import org.jspecify.annotations.NullMarked;
