/**
 * {@code sitaf demo} and {@code sitaf up}: server, agent and simulation as processes of this
 * machine, used as anybody would.
 */
@NullMarked
package org.sitaf.cli.system;

import org.jspecify.annotations.NullMarked;
