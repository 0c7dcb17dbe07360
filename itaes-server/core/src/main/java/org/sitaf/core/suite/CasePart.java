package org.sitaf.core.suite;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.value.TestValue;

/**
 * A part of a suite that is combined by itself.
 *
 * @param candidates the values of each parameter
 * @param held index of the parameter that is fixed to one value; -1 if there is none
 * @param single whether one case is enough
 * @param valid whether all cases are valid or invalid; null if they differ
 */
record CasePart(
    List<List<TestValue>> candidates, int held, boolean single, @Nullable Boolean valid) {
  CasePart {
    candidates = List.copyOf(candidates);
  }

  /** The value of the fixed parameter. */
  TestValue heldValue() {
    return candidates.get(held).get(0);
  }
}
