/** Readers for the reports of coverage tools. */
@NullMarked
package org.sitaf.agent.toolchain.coverage;

import org.jspecify.annotations.NullMarked;
