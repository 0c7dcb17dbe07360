/** The score of a specification with sequences: faults of steps and of their order. */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.score.sequence;
