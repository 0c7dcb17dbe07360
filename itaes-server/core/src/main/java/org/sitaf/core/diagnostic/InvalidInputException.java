package org.sitaf.core.diagnostic;

import java.util.List;
import java.util.stream.Collectors;

/** A user's input cannot be used; holds every problem that was found. */
public final class InvalidInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient List<Diagnostic> diagnostics;

  /** At least one diagnostic says why. */
  public InvalidInputException(List<Diagnostic> diagnostics) {
    super(diagnostics.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** A single problem of a whole document. */
  public static InvalidInputException of(String file, String message) {
    return new InvalidInputException(List.of(Diagnostic.error(file, 0, "", message)));
  }

  /** What is wrong, in the order of its finding. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
