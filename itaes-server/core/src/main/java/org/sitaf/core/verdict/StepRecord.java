package org.sitaf.core.verdict;

import java.util.Objects;

/**
 * The record of a step of a sequence, as written by a test application.
 *
 * @param number of the step in its case, from 1
 * @param name of the call or event in the test model
 * @param atNanos simulation time since the first step of the case began; negative if it is unknown
 * @param record of the step, with the number of the case
 */
public record StepRecord(int number, String name, long atNanos, CaseRecord record) {
  public StepRecord {
    Objects.requireNonNull(name);
    Objects.requireNonNull(record);
  }

  /** The record of a step that its test application could not write. */
  public static StepRecord error(int no, int number, String name, String message) {
    return new StepRecord(number, name, -1, CaseRecord.error(no, message));
  }

  /** A copy with another record. */
  public StepRecord with(CaseRecord other) {
    return new StepRecord(number, name, atNanos, other);
  }
}
