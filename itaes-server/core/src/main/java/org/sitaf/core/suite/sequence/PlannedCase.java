package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.List;

/** A case while it is planned. */
final class PlannedCase {
  private final List<PlannedStep> steps = new ArrayList<>();
  private StepRow initial = StepRow.NONE;
  private int number;
  private int highestNumber;

  /** How a step is meant. */
  enum Role {
    /** Allowed, with valid values. */
    VALID,
    /** Allowed, with an invalid value. */
    INVALID_ROW,
    /** Its guard is false. */
    FORBIDDEN
  }

  /** A step with its values. */
  record PlannedStep(int kind, StepRow row, Role role) {}

  List<PlannedStep> steps() {
    return steps;
  }

  void add(int kind, StepRow row, Role role) {
    steps.add(new PlannedStep(kind, row, role));
  }

  StepRow initial() {
    return initial;
  }

  void setInitial(StepRow row) {
    initial = row;
  }

  boolean contains(int kind) {
    return steps.stream().anyMatch(s -> s.kind() == kind);
  }

  /** The number of a kept case; 0 if it has none yet. */
  int number() {
    return number;
  }

  void setNumber(int kept) {
    number = kept;
  }

  /** The highest number of all kept cases, which no other case gets. */
  int highestNumber() {
    return highestNumber;
  }

  void setHighestNumber(int highest) {
    highestNumber = highest;
  }

  int[] kinds() {
    return steps.stream().mapToInt(PlannedStep::kind).toArray();
  }

  int distinctKinds() {
    return (int) steps.stream().map(PlannedStep::kind).distinct().count();
  }

  boolean hasSameSteps(PlannedCase other) {
    return steps.equals(other.steps);
  }

  /** A new case with the same steps. */
  PlannedCase copy() {
    PlannedCase copy = new PlannedCase();
    copy.steps.addAll(steps);
    return copy;
  }

  boolean isValid() {
    return initial.isValid() && steps.stream().allMatch(s -> s.role() == Role.VALID);
  }
}
