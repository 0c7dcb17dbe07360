package org.sitaf.agent.toolchain;

import java.util.List;

/** The user's files do not compile or do not fit; trying again gives the same. */
public final class CompilationException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient List<SourceDiagnostic> diagnostics;

  /** The message is one sentence; the diagnostics say where. */
  public CompilationException(String message, List<SourceDiagnostic> diagnostics) {
    super(message);
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** What is wrong, in the order of the compiler's finding; may be empty. */
  public List<SourceDiagnostic> diagnostics() {
    return diagnostics;
  }
}
