/** System calls that confined processes may not make, as a seccomp filter. */
@NullMarked
package org.sitaf.agent.sandbox.seccomp;

import org.jspecify.annotations.NullMarked;
