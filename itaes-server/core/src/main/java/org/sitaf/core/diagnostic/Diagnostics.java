package org.sitaf.core.diagnostic;

import java.util.ArrayList;
import java.util.List;

/**
 * Collects what is wrong with the documents of one reading, so that every problem is told at once.
 */
public final class Diagnostics {
  private final List<Diagnostic> collected = new ArrayList<>();

  /** Adds an error. */
  public void error(String file, int line, String element, String message) {
    collected.add(Diagnostic.error(file, line, element, message));
  }

  /** Adds a warning. */
  public void warning(String file, int line, String element, String message) {
    collected.add(Diagnostic.warning(file, line, element, message));
  }

  /** Adds what another reading collected. */
  public void addAll(List<Diagnostic> others) {
    collected.addAll(others);
  }

  /** Whether anything collected makes the input unusable. */
  public boolean hasErrors() {
    return collected.stream().anyMatch(d -> d.severity() == Severity.ERROR);
  }

  /** All that was collected, in the order of its finding. */
  public List<Diagnostic> all() {
    return List.copyOf(collected);
  }

  /**
   * Ends the reading where the input is unusable.
   *
   * @throws InvalidInputException with everything collected, when there is an error among it
   */
  public void throwIfErrors() {
    if (hasErrors()) {
      throw new InvalidInputException(all());
    }
  }
}
