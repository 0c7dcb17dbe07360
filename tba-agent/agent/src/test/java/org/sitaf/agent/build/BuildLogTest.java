package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.Recording;

/** A log stays readable, however much is written. */
class BuildLogTest {
  @TempDir private Path directory;

  @Test
  void limitsRemarksThatAComponentCauses() throws Exception {
    Path file = directory.resolve("log");
    try (BuildLog log = new BuildLog(file, new Recording())) {
      for (int i = 0; i < 100_000; i++) {
        log.remark("a line of the results file is not a test_result and was left out: " + i);
      }
      log.remark("x".repeat(1 << 20));
      log.conclude("y".repeat(1 << 20));
      log.conclude("it is over");
    }

    assertThat(Files.size(file)).isLessThan(BuildLog.REMARKS_LIMIT_BYTES + 10_000);
    assertThat(Files.readString(file))
        .containsOnlyOnce("[sitaf] further remarks are omitted, because they exceed 1 MiB")
        .endsWith("...\n[sitaf] it is over\n");
  }

  @Test
  void limitsOutputIncludingItsHeaders() throws Exception {
    Path file = directory.resolve("log");
    try (BuildLog log = new BuildLog(file, new Recording())) {
      for (int i = 0; i < 1_000_000; i++) {
        log.output("x", 1 + i % 2);
      }
    }

    assertThat(Files.size(file)).isLessThan(BuildLog.OUTPUT_LIMIT_BYTES + 10_000);
    assertThat(Files.readString(file)).contains("output of the test application is cut here");
  }
}
