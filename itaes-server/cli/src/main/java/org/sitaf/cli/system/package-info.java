/**
 * {@code sitaf demo} and {@code sitaf up}: start server, agent and simulation as processes of this
 * machine.
 */
@NullMarked
package org.sitaf.cli.system;

import org.jspecify.annotations.NullMarked;
