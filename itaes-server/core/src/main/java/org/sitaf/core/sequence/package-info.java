/**
 * Sequences of steps over abstract states as integers: which tuples are possible, and words that
 * cover them.
 */
@NullMarked
package org.sitaf.core.sequence;

import org.jspecify.annotations.NullMarked;
