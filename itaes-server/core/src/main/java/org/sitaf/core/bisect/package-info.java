/** Finds the first bad commit of a history with few tests. */
@NullMarked
package org.sitaf.core.bisect;

import org.jspecify.annotations.NullMarked;
