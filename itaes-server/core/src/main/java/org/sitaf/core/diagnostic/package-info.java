/** Problems in a user's input: what is wrong, where, and how to fix it. */
@NullMarked
package org.sitaf.core.diagnostic;

import org.jspecify.annotations.NullMarked;
