/**
 * Scores a specification: injects faults between driver and component, and counts those that the
 * test suite notices. Faults of outputs are applied to the recorded values; faults of inputs are
 * executed as further cases.
 */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.score;
