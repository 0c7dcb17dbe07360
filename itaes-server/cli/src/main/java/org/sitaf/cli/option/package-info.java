/** Options and arguments that several commands share. */
@NullMarked
package org.sitaf.cli.option;

import org.jspecify.annotations.NullMarked;
