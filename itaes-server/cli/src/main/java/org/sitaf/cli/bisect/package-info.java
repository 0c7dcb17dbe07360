/** The command {@code bisect}: finds the commit that broke a component. */
@NullMarked
package org.sitaf.cli.bisect;

import org.jspecify.annotations.NullMarked;
