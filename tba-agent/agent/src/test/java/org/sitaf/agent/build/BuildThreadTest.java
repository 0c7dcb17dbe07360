package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Cancelled;
import org.sitaf.agent.spool.SystemTool;

/** A cancelled build ends even if its thread is blocked. */
@Tag("slow")
@Timeout(300)
class BuildThreadTest {
  @TempDir private Path directory;
  private final Cancellation cancellation = new Cancellation();
  private final CountDownLatch working = new CountDownLatch(1);

  /** Opens a pipe without a writer, which cannot be interrupted. */
  private BuildOutcome hang() {
    return cancellation.guard(
        () -> {
          working.countDown();
          try {
            Files.readAllBytes(directory.resolve("pipe"));
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
          return new Cancelled("not reached");
        });
  }

  @Test
  void aCancelledBuildDoesNotWaitForABlockedThread() throws Exception {
    SystemTool.run(List.of("mkfifo", directory.resolve("pipe").toString()), Duration.ofSeconds(5));
    BuildThread thread = new BuildThread(cancellation, this::hang);
    CompletableFuture<BuildOutcome> outcome =
        CompletableFuture.supplyAsync(() -> thread.run(Duration.ofHours(1)));
    working.await();

    cancellation.request("enough");

    assertThat(outcome.get(30, TimeUnit.SECONDS)).isEqualTo(new Cancelled("enough"));
    Files.writeString(directory.resolve("pipe"), "so that the thread ends");
  }

  @Test
  void cancelsABuildAfterItsTimeout() {
    BuildOutcome outcome =
        new BuildThread(
                cancellation,
                () ->
                    cancellation.guard(
                        () -> {
                          Thread.sleep(30_000);
                          return new Cancelled("not reached");
                        }))
            .run(Duration.ofMillis(100));

    assertThat(outcome).isEqualTo(new Cancelled("the build took longer than 0 minutes"));
  }
}
