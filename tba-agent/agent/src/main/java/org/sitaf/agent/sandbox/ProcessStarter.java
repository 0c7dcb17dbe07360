package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;

/**
 * Starts processes on a thread that lives as long as this program. The kernel ends a process of
 * bubblewrap ({@code --die-with-parent}) with the thread that started it, and the thread of a build
 * ends before a process that was started ahead for the next build.
 */
final class ProcessStarter {
  private static final Executor THREAD =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "sitaf-process-starter");
            thread.setDaemon(true);
            return thread;
          });

  private ProcessStarter() {}

  /** Starts a process; an interrupt of the calling thread does not end the wait, which is short. */
  static Process start(ProcessBuilder builder) throws IOException {
    try {
      return CompletableFuture.supplyAsync(
              () -> {
                try {
                  return builder.start();
                } catch (IOException e) {
                  throw new CompletionException(e);
                }
              },
              THREAD)
          .join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      throw e;
    }
  }
}
