/** The command {@code run}: builds and executes cases on this machine, and prints their results. */
@NullMarked
package org.sitaf.cli.run;

import org.jspecify.annotations.NullMarked;
