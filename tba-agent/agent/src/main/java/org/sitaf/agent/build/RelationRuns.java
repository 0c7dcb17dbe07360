package org.sitaf.agent.build;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.Execution;
import org.sitaf.agent.executor.ExecutionRequest;
import org.sitaf.agent.executor.ParallelExecutor;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.SecondRun;
import org.sitaf.core.suite.SecondRuns;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.ExecutedSecondRun;
import org.sitaf.core.verdict.Verdict;

/**
 * Executes the valid cases with the changed inputs of each relation, in processes of their own.
 * This happens before the cases themselves, so that each case has its final verdict when it ends.
 */
record RelationRuns(TestApplication application, ParallelExecutor executor, CaseSignals signals) {
  /**
   * The executed second runs.
   *
   * @param runs one for each relation, in the order of the model
   * @param suspicions reasons why their records cannot be trusted
   */
  record Executed(List<ExecutedSecondRun> runs, List<String> suspicions) {
    Executed {
      runs = List.copyOf(runs);
      suspicions = List.copyOf(suspicions);
    }
  }

  /**
   * Executes the second runs.
   *
   * @param request of the cases themselves
   * @throws IOException if no process can be started
   */
  Executed execute(ExecutionRequest request, @Nullable BuildSimulator simulator, BuildLog log)
      throws IOException, InterruptedException {
    List<ExecutedSecondRun> executed = new ArrayList<>();
    List<String> suspicions = new ArrayList<>();
    for (SecondRun run :
        SecondRuns.of(application.model(), application.suite(), application.activity().world())) {
      if (run.suite().cases().isEmpty()) {
        executed.add(new ExecutedSecondRun(run, List.of(), ""));
        continue;
      }
      log.remark(
          "relation '%s': executing %d cases with changed inputs"
              .formatted(run.relation(), run.suite().cases().size()));
      List<CaseRecord> records = Collections.synchronizedList(new ArrayList<>());
      Execution execution =
          executor.execute(
              request.apart("relation-" + (executed.size() + 1), run.suite()),
              null,
              log,
              record -> {
                signals.discard(record.no(), simulator);
                records.add(record);
                return unjudged(record);
              });
      execution
          .suspicions()
          .forEach(reason -> suspicions.add("relation '" + run.relation() + "': " + reason));
      executed.add(new ExecutedSecondRun(run, List.copyOf(records), execution.reasonOfRest()));
    }
    return new Executed(executed, suspicions);
  }

  private static CaseResult unjudged(CaseRecord record) {
    return new CaseResult(
        record.no(), Verdict.PASS, List.of(), List.of(), List.of(), record.time(), "");
  }
}
