/** Reads folders and histories of Git repositories, without any program or configuration. */
@NullMarked
package org.sitaf.cli.git;

import org.jspecify.annotations.NullMarked;
