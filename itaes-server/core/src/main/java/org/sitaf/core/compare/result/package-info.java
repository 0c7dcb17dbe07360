/** Compares two results that exist: each version ran once, and nothing runs again. */
@NullMarked
package org.sitaf.core.compare.result;

import org.jspecify.annotations.NullMarked;
