package org.sitaf.agent.analysis;

import java.time.Duration;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.sitaf.agent.build.AnalysisReport.Repeated;
import org.sitaf.core.flaky.FlakyCases;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Executes the cases of a suite several times, and finds those that differ between the runs. */
final class RepeatedCases {
  private static final double MILLIS_PER_SECOND = 1e3;

  private final Runner runner;
  private final Consumer<String> log;

  /** Executes all cases once. */
  @FunctionalInterface
  interface Runner {
    /**
     * Executes all cases in new processes.
     *
     * @param variation of the processes; see {@link org.sitaf.agent.toolchain.ProcessPlace}
     * @param signals receives the signals of the cases, in any thread
     */
    TestResult run(int variation, BiConsumer<Integer, Trace> signals) throws InterruptedException;
  }

  /**
   * Begins without runs.
   *
   * @param log gets a line about each run
   */
  RepeatedCases(Runner runner, Consumer<String> log) {
    this.runner = runner;
    this.log = log;
  }

  /**
   * Executes the cases.
   *
   * @param analysed the result whose verdicts come first
   * @param limit of a case
   */
  Repeated run(TestResult analysed, int runs, Duration limit) throws InterruptedException {
    FlakyCases flaky = new FlakyCases(limit.toMillis() / MILLIS_PER_SECOND);
    flaky.addEarlier(analysed);
    for (int run = 1; run <= runs; run++) {
      TestResult result = runner.run(run - 1, flaky::signals);
      flaky.add(result);
      long failed = result.cases().stream().filter(c -> c.verdict() != Verdict.PASS).count();
      log.accept(
          "run "
              + run
              + " of "
              + runs
              + ": "
              + failed
              + " of "
              + result.cases().size()
              + " cases did not pass");
    }
    return new Repeated(runs, flaky.find());
  }
}
