/**
 * Conditions over time in signal temporal logic: parses formulas and evaluates them over the
 * samples of a case, with the truth value and the quantitative robustness (Donzé and Maler, FORMATS
 * 2010).
 */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.trajectory;
