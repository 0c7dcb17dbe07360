/** The command line interface. */
@NullMarked
package org.sitaf.cli;

import org.jspecify.annotations.NullMarked;
