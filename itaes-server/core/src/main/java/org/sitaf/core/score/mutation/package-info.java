/**
 * Small changes of a component's sources, as of mutation testing, and how many of them the cases of
 * a suite notice.
 */
@NullMarked
package org.sitaf.core.score.mutation;

import org.jspecify.annotations.NullMarked;
