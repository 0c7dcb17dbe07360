package org.sitaf.core.compare;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A difference between the base version and the new version in one case.
 *
 * @param no number of the case; 0 if no single case is concerned
 * @param valid whether all inputs of the case are valid
 * @param kind what differs
 * @param output name of the output, signal or called method; empty for the whole case
 * @param inputs literals by name, in the order of the parameters
 * @param base what the base version gave
 * @param now what the new version gave
 * @param at seconds after the call of the first divergent step; null if time does not matter
 * @param change what differences of a group have in common in addition to kind and output
 * @param deviation largest absolute difference of numbers; NaN if the difference is not numeric
 * @param step the first step that differs; null if the case is not a sequence, or if it differs as
 *     a whole
 */
public record Difference(
    String model,
    int no,
    boolean valid,
    DifferenceClass kind,
    String output,
    Map<String, String> inputs,
    String base,
    String now,
    @Nullable Double at,
    String change,
    double deviation,
    @Nullable Step step) {
  /**
   * A step of a sequence.
   *
   * @param number from 1
   * @param call name and values: {@code Read(1, 7)}
   */
  public record Step(int number, String call) {
    @Override
    public String toString() {
      return "step " + number + ", " + call;
    }
  }

  private static final int MAX_TEXT = 10_000;

  public Difference {
    Objects.requireNonNull(model);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(output);
    inputs = Collections.unmodifiableMap(new LinkedHashMap<>(inputs));
    base = shortened(base);
    now = shortened(now);
    Objects.requireNonNull(change);
  }

  /** A difference of a case that is not a sequence. */
  public Difference(
      String model,
      int no,
      boolean valid,
      DifferenceClass kind,
      String output,
      Map<String, String> inputs,
      String base,
      String now,
      @Nullable Double at,
      String change,
      double deviation) {
    this(model, no, valid, kind, output, inputs, base, now, at, change, deviation, null);
  }

  private static String shortened(String text) {
    return text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "…";
  }

  /**
   * Whether two runs of the same version that differ in this respect cast doubt on a difference
   * between the versions.
   *
   * @param found a difference between the versions
   */
  boolean castsDoubtOn(Difference found) {
    if (!found.model.equals(model) || found.no != no) {
      return false;
    }
    // What follows a step depends on it.
    if (step != null && found.step != null && step.number() <= found.step.number()) {
      return true;
    }
    if (kind == DifferenceClass.ERROR || found.kind == DifferenceClass.VERDICT) {
      return true;
    }
    return kind == found.kind && (kind.isOnePerCase() || output.equals(found.output));
  }
}
