package org.sitaf.core.score;

import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * How many injected faults a specification notices.
 *
 * @param injected number of faults
 * @param noticed number of faults with which a case that passes without them does not pass
 * @param equivalent number of faults that change no recorded value
 * @param survivors the other faults
 * @param byOutput the faults that change an output, by its name
 * @param warnings weaknesses of the specification as a whole
 */
public record SpecificationScore(
    int injected,
    int noticed,
    int equivalent,
    List<Survivor> survivors,
    Map<String, Count> byOutput,
    List<String> warnings) {
  public SpecificationScore {
    survivors = List.copyOf(survivors);
    byOutput = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(byOutput));
    warnings = List.copyOf(warnings);
  }

  /** The share of the faults with an effect that is noticed, from 0 to 1; 1 without such faults. */
  public double share() {
    int effective = injected - equivalent;
    return effective == 0 ? 1 : (double) noticed / effective;
  }

  /**
   * A fault with an effect that no case notices.
   *
   * @param where the output, input or required method
   * @param suggestion what to add to the specification
   */
  public record Survivor(String fault, String where, String suggestion) {
    public Survivor {
      Objects.requireNonNull(fault);
      Objects.requireNonNull(where);
      Objects.requireNonNull(suggestion);
    }
  }

  /**
   * Numbers of faults that change an output.
   *
   * @param changed number of faults
   * @param noticed how many of them are noticed
   */
  public record Count(int changed, int noticed) {
    /** With one more fault. */
    public Count plus(boolean isNoticed) {
      return new Count(changed + 1, noticed + (isNoticed ? 1 : 0));
    }
  }
}
