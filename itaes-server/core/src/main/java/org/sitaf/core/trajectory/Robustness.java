package org.sitaf.core.trajectory;

/**
 * The result of a formula at the first sample of a trace.
 *
 * @param holds the truth value
 * @param margin the quantitative robustness; may be infinite
 * @param sample index of the earliest sample that decides the truth value; the last one if only the
 *     end of the trace does
 */
public record Robustness(boolean holds, double margin, int sample) {}
