/** Sequence covering arrays over integers. Depends on no model, only on the package combine. */
@NullMarked
package org.sitaf.core.sequence.array;

import org.jspecify.annotations.NullMarked;
