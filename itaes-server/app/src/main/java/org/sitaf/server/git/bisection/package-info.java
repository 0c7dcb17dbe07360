/** Finds the first bad commit between two commits of a branch that were built. */
@NullMarked
package org.sitaf.server.git.bisection;

import org.jspecify.annotations.NullMarked;
