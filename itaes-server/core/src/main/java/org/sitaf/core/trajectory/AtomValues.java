package org.sitaf.core.trajectory;

/**
 * The values of an atom at all samples.
 *
 * @param truths one per sample
 * @param margins one per sample: how far the atom is from the other truth value; without NaN
 */
@SuppressWarnings("ArrayRecordComponent") // Large arrays, which are read only in this package.
record AtomValues(boolean[] truths, double[] margins) {
  AtomValues {
    if (truths.length != margins.length || truths.length == 0) {
      throw new IllegalArgumentException("an atom needs a truth value and a margin at each sample");
    }
  }
}
