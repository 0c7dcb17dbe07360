package org.sitaf.core.score.sequence;

import org.sitaf.core.score.sequence.SequenceRecords.Recorded;
import org.sitaf.core.suite.TestCase;

/**
 * What a fault changes in one case.
 *
 * @param passes whether the case passes without the fault
 */
record ChangedCase(TestCase testCase, Recorded without, Recorded with, boolean passes) {
  /** The index of the first step that differs; -1 if none does. */
  int firstStep() {
    int with = this.with.record().steps().size();
    int without = this.without.record().steps().size();
    for (int i = 0; i < Math.min(with, without); i++) {
      if (SequenceRecords.differ(
          this.without.record().steps().get(i).record(),
          this.with.record().steps().get(i).record())) {
        return i;
      }
    }
    return -1;
  }
}
