package org.sitaf.core.trajectory;

import java.util.List;
import java.util.Objects;

/**
 * A formula with the texts of its atoms.
 *
 * @param intervals all intervals that the text contains, with their positions
 */
record ParsedFormula(Formula formula, List<AtomText> atoms, List<IntervalText> intervals) {
  ParsedFormula {
    Objects.requireNonNull(formula);
    atoms = List.copyOf(atoms);
    intervals = List.copyOf(intervals);
  }

  /** The text of an atom and its position in the formula, from 1. */
  record AtomText(String text, int line, int column) {}

  /** An interval and its position in the formula, from 1. */
  record IntervalText(Interval interval, int line, int column) {}
}
