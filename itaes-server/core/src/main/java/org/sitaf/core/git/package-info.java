/** Reads files of Git commits from objects, without any program or configuration. */
@NullMarked
package org.sitaf.core.git;

import org.jspecify.annotations.NullMarked;
