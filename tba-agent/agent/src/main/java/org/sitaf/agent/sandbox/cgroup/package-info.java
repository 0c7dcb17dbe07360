/** Control groups of the kernel: one for each confined process and all that it starts. */
@NullMarked
package org.sitaf.agent.sandbox.cgroup;

import org.jspecify.annotations.NullMarked;
