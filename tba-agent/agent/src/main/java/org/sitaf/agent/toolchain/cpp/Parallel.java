package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.sitaf.agent.sandbox.ToolResult;

/** Runs tools in parallel, one per processor. */
final class Parallel {
  private Parallel() {}

  /** Runs one of them. */
  interface Run<T> {
    ToolResult of(T work) throws IOException, InterruptedException;
  }

  /** Runs all of them and returns the results in the same order. */
  static <T> List<ToolResult> run(List<T> works, Run<T> run)
      throws IOException, InterruptedException {
    int atOnce = Math.max(1, Math.min(works.size(), Runtime.getRuntime().availableProcessors()));
    ExecutorService threads =
        Executors.newFixedThreadPool(
            atOnce,
            task -> {
              Thread thread = new Thread(task, "sitaf-compile");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<Future<ToolResult>> pending = new ArrayList<>();
      for (T work : works) {
        pending.add(threads.submit(() -> run.of(work)));
      }
      List<ToolResult> ends = new ArrayList<>();
      for (Future<ToolResult> one : pending) {
        ends.add(one.get());
      }
      return ends;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      throw new IOException(e.getCause());
    } finally {
      // Interrupts running tasks, which end their processes.
      threads.shutdownNow();
    }
  }
}
