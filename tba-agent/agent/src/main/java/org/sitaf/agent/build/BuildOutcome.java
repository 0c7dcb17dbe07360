package org.sitaf.agent.build;

import java.util.List;
import java.util.Objects;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.verdict.TestResult;

/** How a build ended. A build that could not run never looks like a failed test. */
public sealed interface BuildOutcome {

  /**
   * Every case has a verdict; DONT if it was not executed.
   *
   * @param warnings of the compiler about the user's sources, one line each
   */
  record Completed(TestResult result, List<String> warnings) implements BuildOutcome {
    public Completed {
      Objects.requireNonNull(result);
      warnings = List.copyOf(warnings);
    }
  }

  /** An analysis of a build ended. */
  record Analysed(AnalysisReport report) implements BuildOutcome {
    public Analysed {
      Objects.requireNonNull(report);
    }
  }

  /**
   * The user's files do not compile. A retry gives the same result. The number and length of errors
   * are limited.
   */
  record CompilationFailed(String message, List<SourceDiagnostic> diagnostics)
      implements BuildOutcome {
    private static final int MAX_ERRORS = 1000;
    private static final int MAX_LENGTH = 8000;

    public CompilationFailed {
      message = shortened(message);
      diagnostics =
          diagnostics.stream()
              .limit(MAX_ERRORS)
              .map(
                  d ->
                      new SourceDiagnostic(
                          d.file(), d.line(), d.column(), shortened(d.message()), d.generated()))
              .toList();
    }

    private static String shortened(String text) {
      return text.length() <= MAX_LENGTH ? text : text.substring(0, MAX_LENGTH) + "...";
    }
  }

  /** This machine or the simulation failed; a retry may succeed. */
  record InfrastructureFailed(String message) implements BuildOutcome {
    public InfrastructureFailed {
      Objects.requireNonNull(message);
    }
  }

  /** The build was cancelled. */
  record Cancelled(String reason) implements BuildOutcome {
    public Cancelled {
      Objects.requireNonNull(reason);
    }
  }
}
