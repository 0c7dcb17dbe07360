package org.sitaf.core.diagnostic;

import java.util.List;
import java.util.stream.Collectors;

/** Thrown when a user's input cannot be used. Holds every problem that was found. */
public final class InvalidInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient List<Diagnostic> diagnostics;

  /** Creates an exception from at least one diagnostic. */
  public InvalidInputException(List<Diagnostic> diagnostics) {
    super(diagnostics.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** Creates an exception for a single problem that concerns a whole document. */
  public static InvalidInputException of(String file, String message) {
    return new InvalidInputException(List.of(Diagnostic.error(file, 0, "", message)));
  }

  /** The problems in the order in which they were found. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
