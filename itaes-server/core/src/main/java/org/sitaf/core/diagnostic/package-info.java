/** What is wrong with a user's input: what, where, and what to do. */
@NullMarked
package org.sitaf.core.diagnostic;

import org.jspecify.annotations.NullMarked;
