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

/** A build is over when nobody wants it any more, whatever its thread hangs on. */
@Tag("slow")
@Timeout(60)
class BuildThreadTest {
  @TempDir private Path directory;
  private final Cancellation cancellation = new Cancellation();
  private final CountDownLatch working = new CountDownLatch(1);

  /** Opens a pipe that nobody writes to, which no interrupt ends. */
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
  void aCancelledOneDoesNotWaitForAnythingThatDoesNotEnd() throws Exception {
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
  void oneThatTakesTooLongIsCancelled() {
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
