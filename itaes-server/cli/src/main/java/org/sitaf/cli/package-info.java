/** The commands that need no server, and those that start one. */
@NullMarked
package org.sitaf.cli;

import org.jspecify.annotations.NullMarked;
