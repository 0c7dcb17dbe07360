package org.sitaf.agent.analysis;

import java.util.Objects;
import org.sitaf.core.verdict.TestResult;

/** What to analyse. */
public sealed interface AnalysisOrder {
  /** Maximum number of further cases. */
  int maxCases();

  /** Explains the failures of a result. */
  record Explain(TestResult analysed, int maxCases) implements AnalysisOrder {
    public Explain {
      Objects.requireNonNull(analysed);
      check(maxCases);
    }
  }

  /** Scores the specification. */
  record Score(int maxCases) implements AnalysisOrder {
    public Score {
      check(maxCases);
    }
  }

  /** Executes the cases again and compares the runs, also with the verdicts of a result. */
  record Repeat(TestResult analysed, int maxCases) implements AnalysisOrder {
    public Repeat {
      Objects.requireNonNull(analysed);
      check(maxCases);
    }
  }

  private static void check(int maxCases) {
    if (maxCases < 0) {
      throw new IllegalArgumentException("the number of further cases must not be negative");
    }
  }
}
