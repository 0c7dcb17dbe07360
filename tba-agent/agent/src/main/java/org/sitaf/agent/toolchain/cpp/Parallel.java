package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.sitaf.agent.sandbox.ToolEnd;

/** Runs tools side by side, one for each processor. */
final class Parallel {
  private Parallel() {}

  /** How one of them is run. */
  interface Run<T> {
    ToolEnd of(T work) throws IOException, InterruptedException;
  }

  /** Runs all, and gives their ends in the same order. */
  static <T> List<ToolEnd> run(List<T> works, Run<T> run) throws IOException, InterruptedException {
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
      List<Future<ToolEnd>> pending = new ArrayList<>();
      for (T work : works) {
        pending.add(threads.submit(() -> run.of(work)));
      }
      List<ToolEnd> ends = new ArrayList<>();
      for (Future<ToolEnd> one : pending) {
        ends.add(one.get());
      }
      return ends;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      throw new IOException(e.getCause());
    } finally {
      // Those at work are interrupted, and their processes end with them.
      threads.shutdownNow();
    }
  }
}
