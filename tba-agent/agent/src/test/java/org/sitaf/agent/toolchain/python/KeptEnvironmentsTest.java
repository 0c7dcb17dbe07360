package org.sitaf.agent.toolchain.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.spool.SharedCache;

class KeptEnvironmentsTest {
  private static final int BYTES = 1000;

  @TempDir private Path directory;

  private KeptEnvironments keeping(long bytes) {
    return new KeptEnvironments(new SharedCache(directory), bytes, Clock.systemUTC());
  }

  private String environment(int digit, Duration unused) throws IOException {
    String name = Integer.toString(digit).repeat(24);
    Path entry = Files.createDirectories(directory.resolve(name));
    Path module = Files.createDirectories(entry.resolve("environment/lib")).resolve("module.py");
    Files.write(module, new byte[BYTES]);
    KeptEnvironments.measure(entry);
    Files.setLastModifiedTime(entry, FileTime.from(Instant.now().minus(unused)));
    return name;
  }

  private Stream<String> left() throws IOException {
    try (Stream<Path> all = Files.list(directory)) {
      return all.map(path -> path.getFileName().toString()).sorted().toList().stream();
    }
  }

  @Test
  void theLeastRecentlyUsedAreRemovedUntilTheRestIsSmallEnough() throws Exception {
    String old = environment(1, Duration.ofDays(30));
    String older = environment(2, Duration.ofDays(40));
    String recent = environment(3, Duration.ofDays(3));
    Files.createDirectories(directory.resolve("wheels-" + "4".repeat(24)));
    keeping(2 * BYTES + 10).shrink();
    assertThat(left()).containsExactly(old, recent, "wheels-" + "4".repeat(24));
    keeping(10).shrink();
    assertThat(left()).doesNotContain(old, older).contains(recent);
  }

  @Test
  void oneThatMayBeInUseStays() throws Exception {
    String used = environment(1, Duration.ofDays(30));
    String running = environment(2, Duration.ofHours(40));
    environment(3, Duration.ofDays(20));
    KeptEnvironments kept = keeping(BYTES);
    kept.use(used);
    kept.shrink();
    assertThat(left()).containsExactly(used, running);
  }

  @Test
  void oneWithoutAKnownSizeIsMeasured() throws Exception {
    String first = environment(1, Duration.ofDays(30));
    String second = environment(2, Duration.ofDays(20));
    Files.delete(directory.resolve(first).resolve("bytes"));
    Files.setLastModifiedTime(
        directory.resolve(first), FileTime.from(Instant.now().minus(Duration.ofDays(30))));
    Files.writeString(directory.resolve(second).resolve("bytes"), "no number");
    Files.setLastModifiedTime(
        directory.resolve(second), FileTime.from(Instant.now().minus(Duration.ofDays(20))));
    keeping(BYTES + 500).shrink();
    assertThat(left()).containsExactly(second);
  }

  @Test
  void usingAnEnvironmentOfNobodyIsNoError() {
    keeping(1).use("5".repeat(24));
  }
}
