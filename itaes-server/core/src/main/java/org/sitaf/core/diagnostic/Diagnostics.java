package org.sitaf.core.diagnostic;

import java.util.ArrayList;
import java.util.List;

/**
 * Collects the problems found while documents are read, so that all of them are reported at once.
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

  /** Adds diagnostics that were collected elsewhere. */
  public void addAll(List<Diagnostic> others) {
    collected.addAll(others);
  }

  /** Whether at least one error was collected. */
  public boolean hasErrors() {
    return collected.stream().anyMatch(d -> d.severity() == Severity.ERROR);
  }

  /** All diagnostics in the order in which they were found. */
  public List<Diagnostic> all() {
    return List.copyOf(collected);
  }

  /**
   * Throws if at least one error was collected.
   *
   * @throws InvalidInputException with all diagnostics, warnings included
   */
  public void throwIfErrors() {
    if (hasErrors()) {
      throw new InvalidInputException(all());
    }
  }
}
