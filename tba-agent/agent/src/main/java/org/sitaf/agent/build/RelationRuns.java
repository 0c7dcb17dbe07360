package org.sitaf.agent.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.Execution;
import org.sitaf.agent.executor.ExecutionRequest;
import org.sitaf.agent.executor.OutputSink;
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
record RelationRuns(
    TestApplication application,
    ParallelExecutor executor,
    CaseSignals signals,
    @Nullable RecordingOrder order) {
  /**
   * The executed second runs.
   *
   * @param runs one for each relation, in the order of the model
   * @param suspicions reasons why their records cannot be trusted
   * @param recordings the folder of the recordings of each relation; empty if none are recorded
   */
  record Executed(List<ExecutedSecondRun> runs, List<String> suspicions, List<Path> recordings) {
    Executed {
      recordings = List.copyOf(recordings);
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
    List<Path> recordings = new ArrayList<>();
    for (SecondRun run :
        SecondRuns.of(application.model(), application.suite(), application.activity().world())) {
      String name = "relation-" + (executed.size() + 1);
      Path recording =
          request.recording() == null || order == null
              ? null
              : request.recording().resolveSibling("recording." + name);
      if (recording != null) {
        recordings.add(recording.resolveSibling("recording." + name + ".kept"));
      }
      if (run.suite().cases().isEmpty()) {
        executed.add(new ExecutedSecondRun(run, List.of(), ""));
        continue;
      }
      log.remark(
          "relation '%s': executing %d cases with changed inputs"
              .formatted(run.relation(), run.suite().cases().size()));
      List<CaseRecord> records = Collections.synchronizedList(new ArrayList<>());
      Execution execution;
      try (Recordings kept =
          recording == null ? null : recordings(run, recording, recordings.get(executed.size()))) {
        execution =
            executor.execute(
                request.apart(name, run.suite(), recording),
                null,
                log,
                record -> {
                  signals.discard(record.no(), simulator);
                  records.add(record);
                  CaseResult unjudged = unjudged(record);
                  if (kept != null) {
                    kept.expect(unjudged);
                  }
                  return unjudged;
                });
      }
      execution
          .suspicions()
          .forEach(reason -> suspicions.add("relation '" + run.relation() + "': " + reason));
      executed.add(new ExecutedSecondRun(run, List.copyOf(records), execution.reasonOfRest()));
    }
    return new Executed(executed, suspicions, recordings);
  }

  /**
   * Keeps the recordings of the second runs until it is known which cases are kept. The limits are
   * those of the cases, so a component cannot fill the disk.
   */
  private Recordings recordings(SecondRun run, Path recording, Path kept) {
    RecordingOrder limits = Objects.requireNonNull(order);
    return new Recordings(
        executor.recordingFolders(run.suite(), recording),
        recording.resolveSibling(recording.getFileName() + ".collected"),
        List.of(),
        new RecordingOrder(
            kept, RecordingOrder.Cases.ALL, limits.maxRecordings(), limits.maxBytes()),
        new Unreported(),
        new Unreported());
  }

  /** The recordings of second runs are reported with their cases. */
  private static final class Unreported extends QuietBuild implements OutputSink {
    @Override
    public void output(String text, int caseNo) {
      // Nothing is reported.
    }

    @Override
    public void remark(String line) {
      // Nothing is reported.
    }
  }

  private static CaseResult unjudged(CaseRecord record) {
    return new CaseResult(
        record.no(), Verdict.PASS, List.of(), List.of(), List.of(), record.time(), "");
  }
}
