/** Linux control groups: one group per confined process and its children. */
@NullMarked
package org.sitaf.agent.sandbox.cgroup;

import org.jspecify.annotations.NullMarked;
