package org.sitaf.agent.executor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;

/**
 * Executes a suite in several simulations in parallel, each with a contiguous shard of the cases.
 * The results equal those of a sequential execution and are in the order of the suite.
 *
 * @param each executes one shard
 * @param sessions maximum number of shards
 */
public record ParallelExecutor(TestApplicationExecutor each, int sessions) {
  /** Shards with fewer cases do not pay for the start of a process. */
  private static final int MIN_CASES = 10;

  public ParallelExecutor {
    Objects.requireNonNull(each);
    if (sessions < 1) {
      throw new IllegalArgumentException("sessions must be at least 1");
    }
  }

  /** Whether the cases run in one process, as long as none of them ends it. */
  public boolean isInSequence(TestSuite suite) {
    return shards(suite) < 2;
  }

  private int shards(TestSuite suite) {
    return Math.min(sessions, suite.cases().size() / MIN_CASES);
  }

  private static List<TestCase> casesOfShard(TestSuite suite, int shard, int shards) {
    List<TestCase> cases = suite.cases();
    return cases.subList(cases.size() * (shard - 1) / shards, cases.size() * shard / shards);
  }

  /**
   * The folder that holds the recording of each case, by the number of the case.
   *
   * @param recording the folder of the execution request
   */
  public Map<Integer, Path> recordingFolders(TestSuite suite, Path recording) {
    int shards = shards(suite);
    Map<Integer, Path> folders = new HashMap<>();
    if (shards < 2) {
      suite.cases().forEach(testCase -> folders.put(testCase.no(), recording));
    }
    for (int shard = 1; shards >= 2 && shard <= shards; shard++) {
      Path folder = ExecutionRequest.recordingOfShard(recording, shard);
      casesOfShard(suite, shard, shards).forEach(testCase -> folders.put(testCase.no(), folder));
    }
    return folders;
  }

  /**
   * Runs the cases; see {@link TestApplicationExecutor#execute}.
   *
   * @param early used for sequential execution only
   * @param judge gives the result of each recorded case; called by several threads, one at a time
   */
  public Execution execute(
      ExecutionRequest request,
      @Nullable EarlyProcess early,
      OutputSink sink,
      Function<CaseRecord, CaseResult> judge)
      throws IOException, InterruptedException {
    int shards = shards(request.suite());
    if (shards < 2) {
      return each.execute(request, early, sink, judge);
    }
    sink.remark("the cases run in " + shards + " simulations in parallel");
    Object oneAtATime = new Object();
    Function<CaseRecord, CaseResult> inTurn =
        record -> {
          synchronized (oneAtATime) {
            return judge.apply(record);
          }
        };
    List<Future<Execution>> running = new ArrayList<>();
    ExecutorService threads = Executors.newFixedThreadPool(shards);
    try {
      for (int number = 1; number <= shards; number++) {
        ExecutionRequest part = request.part(number, casesOfShard(request.suite(), number, shards));
        running.add(threads.submit(() -> each.execute(part, null, sink, inTurn)));
      }
      return joined(running);
    } finally {
      // Shards that still run after a failure or cancellation end their processes.
      threads.shutdownNow();
      while (!threads.isTerminated()) {
        awaitEnd(threads);
      }
    }
  }

  private static Execution joined(List<Future<Execution>> running)
      throws IOException, InterruptedException {
    List<CaseResult> results = new ArrayList<>();
    Set<String> suspicions = new LinkedHashSet<>();
    String reason = "";
    for (Future<Execution> part : running) {
      try {
        Execution execution = part.get();
        results.addAll(execution.results());
        suspicions.addAll(execution.suspicions());
        if (reason.isEmpty()) {
          reason = execution.reasonOfRest();
        }
      } catch (ExecutionException e) {
        if (e.getCause() instanceof IOException failure) {
          throw failure;
        }
        throw new IllegalStateException("a shard of the suite failed", e.getCause());
      }
    }
    return new Execution(results, reason, List.copyOf(suspicions));
  }

  private static void awaitEnd(ExecutorService threads) {
    boolean interrupted = false;
    try {
      threads.awaitTermination(1, java.util.concurrent.TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
