/** The command {@code campaign}. */
@NullMarked
package org.sitaf.cli.campaign;

import org.jspecify.annotations.NullMarked;
