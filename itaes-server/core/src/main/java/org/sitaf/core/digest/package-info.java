/** Digests of contents. */
@NullMarked
package org.sitaf.core.digest;

import org.jspecify.annotations.NullMarked;
