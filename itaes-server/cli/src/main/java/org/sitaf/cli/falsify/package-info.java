/** The command {@code falsify}. */
@NullMarked
package org.sitaf.cli.falsify;

import org.jspecify.annotations.NullMarked;
