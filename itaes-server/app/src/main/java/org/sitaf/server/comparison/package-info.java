/** Compares the results of two builds by the values that they contain. */
@NullMarked
package org.sitaf.server.comparison;

import org.jspecify.annotations.NullMarked;
