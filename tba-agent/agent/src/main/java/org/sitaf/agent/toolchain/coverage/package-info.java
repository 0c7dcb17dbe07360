/** Reads what the coverage tools of several languages print. */
@NullMarked
package org.sitaf.agent.toolchain.coverage;

import org.jspecify.annotations.NullMarked;
