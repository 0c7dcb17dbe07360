/** Covering arrays that algebra gives: smaller than any search finds, where the levels fit. */
@NullMarked
package org.sitaf.core.combine.construction;

import org.jspecify.annotations.NullMarked;
