package org.sitaf.agent.toolchain;

import java.util.List;

/** The user's files do not compile. A retry gives the same result. */
public final class CompilationException extends Exception {
  /** All errors are in the generated sources: the component has other methods or types. */
  public static final String MISFIT =
      "the component does not fit the generated test application, which calls what the interface"
          + " declares (change the component, or write an adapter: ./sitaf harness FOLDER"
          + " --adapter)";

  private static final long serialVersionUID = 1L;

  private final transient List<SourceDiagnostic> diagnostics;

  /** The message is one sentence; the diagnostics hold the locations. */
  public CompilationException(String message, List<SourceDiagnostic> diagnostics) {
    super(message);
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** The errors in the order of the compiler's output; may be empty. */
  public List<SourceDiagnostic> diagnostics() {
    return diagnostics;
  }
}
