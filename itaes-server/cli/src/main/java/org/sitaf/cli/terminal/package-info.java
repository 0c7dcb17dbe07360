/** Text, progress and signals of a terminal. */
@NullMarked
package org.sitaf.cli.terminal;

import org.jspecify.annotations.NullMarked;
