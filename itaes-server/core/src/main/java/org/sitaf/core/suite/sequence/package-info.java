/** Suites of sequences: the abstract states of a model's steps, and the cases that cover them. */
@NullMarked
package org.sitaf.core.suite.sequence;

import org.jspecify.annotations.NullMarked;
