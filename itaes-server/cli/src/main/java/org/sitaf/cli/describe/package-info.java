/** Prints interfaces: reads files from the command line and formats descriptions as text. */
@NullMarked
package org.sitaf.cli.describe;

import org.jspecify.annotations.NullMarked;
