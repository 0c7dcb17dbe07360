/** The commands {@code explain} and {@code replay}. */
@NullMarked
package org.sitaf.cli.explain;

import org.jspecify.annotations.NullMarked;
