package org.sitaf.agent.build;

import java.util.List;
import java.util.Objects;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.verdict.TestResult;

/** How a build ended. "Could not run" never looks like "test failed". */
public sealed interface BuildOutcome {

  /** Every case has a verdict; DONT where it could not be executed. */
  record Completed(TestResult result) implements BuildOutcome {
    public Completed {
      Objects.requireNonNull(result);
    }
  }

  /**
   * The user's files do not compile or do not fit; trying again gives the same. A compiler may find
   * more to say than anyone reads: what is beyond that is left out.
   */
  record CompilationFailed(String message, List<SourceDiagnostic> diagnostics)
      implements BuildOutcome {
    private static final int MOST = 1000;
    private static final int LONGEST = 8000;

    public CompilationFailed {
      message = shortened(message);
      diagnostics =
          diagnostics.stream()
              .limit(MOST)
              .map(
                  d ->
                      new SourceDiagnostic(
                          d.file(), d.line(), d.column(), shortened(d.message()), d.generated()))
              .toList();
    }

    private static String shortened(String text) {
      return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "...";
    }
  }

  /** This machine or the simulation is at fault; another attempt may succeed. */
  record InfrastructureFailed(String message) implements BuildOutcome {
    public InfrastructureFailed {
      Objects.requireNonNull(message);
    }
  }

  /** Somebody did not want it any more. */
  record Cancelled(String reason) implements BuildOutcome {
    public Cancelled {
      Objects.requireNonNull(reason);
    }
  }
}
