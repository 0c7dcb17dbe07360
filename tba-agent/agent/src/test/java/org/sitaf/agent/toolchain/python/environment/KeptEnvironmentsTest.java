package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
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
    KeptEnvironments.use(directory.resolve(used));
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

  /** An unpacked wheel, whose file an environment has too. */
  private String wheel(int digit, Duration unused, @Nullable String environment)
      throws IOException {
    String name = UnpackedWheels.PREFIX + Integer.toString(digit).repeat(24);
    Path entry = Files.createDirectories(directory.resolve(name));
    Path module = Files.createDirectories(entry.resolve("tree/lib")).resolve("module.py");
    Files.write(module, new byte[BYTES]);
    KeptEnvironments.measure(entry);
    if (environment != null) {
      Path folder = directory.resolve(environment);
      FileTime used = Files.getLastModifiedTime(folder);
      Files.createLink(folder.resolve("environment/lib/linked.py"), module);
      KeptEnvironments.measure(folder);
      Files.setLastModifiedTime(folder, used);
    }
    Files.setLastModifiedTime(entry, FileTime.from(Instant.now().minus(unused)));
    return name;
  }

  @Test
  void wheelsThatNoEnvironmentHasAreRemovedFirst() throws Exception {
    String older = environment(1, Duration.ofDays(30));
    String newer = environment(2, Duration.ofDays(20));
    String shared = wheel(3, Duration.ofDays(40), older);
    String unused = wheel(4, Duration.ofDays(10), null);
    String recent = wheel(5, Duration.ofHours(1), null);

    keeping(5 * BYTES + 10).shrink();
    assertThat(left()).containsExactly(older, newer, shared, unused, recent);
    keeping(5 * BYTES - 1).shrink();
    assertThat(left()).containsExactly(older, newer, shared, recent);
    keeping(4 * BYTES - 1).shrink();
    assertThat(left()).containsExactly(newer, recent);
  }

  @Test
  void usingAnEnvironmentOfNobodyIsNoError() {
    KeptEnvironments.use(directory.resolve("5".repeat(24)));
  }
}
