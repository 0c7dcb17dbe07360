package org.sitaf.cli.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.cli.terminal.ProgressLine;

@Timeout(60)
@Tag("slow") // Most of it is waiting.
class StartedProcessTest {
  private static final Duration SHORT = Duration.ofSeconds(1);
  private static final Duration LONG = Duration.ofSeconds(50);

  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ProgressLine progress =
      new ProgressLine(new PrintStream(output, true, StandardCharsets.UTF_8));

  @TempDir private Path directory;

  private StartedProcess started(String name, String script) throws IOException {
    return new StartedProcess(
        name,
        List.of("sh", "-c", script),
        Map.of(),
        directory.resolve(name + ".log"),
        Pattern.compile("^ready (.*)"));
  }

  @Test
  void returnsTheReadyLine() throws Exception {
    try (StartedProcess process = started("one", "echo begun; echo ready here; read end")) {
      assertThat(process.awaitReady(new StartupTimeout(LONG, LONG), progress).group(1))
          .isEqualTo("here");
    }
  }

  @Test
  void waitsForAProcessThatWritesToItsLog() throws Exception {
    String script =
        "for i in 1 2 3 4 5 6 7 8; do sleep 0.4; echo step $i; done; echo ready at last";
    try (StartedProcess process = started("one", script)) {
      assertThat(process.awaitReady(new StartupTimeout(SHORT, LONG), progress).group(1))
          .isEqualTo("at last");
    }
  }

  @Test
  void waitsForAProcessThatUsesTheProcessor() throws Exception {
    String computes =
        "end=$(($(date +%s) + 4)); while [ $(date +%s) -lt $end ]; do i=0;"
            + " while [ $i -lt 20000 ]; do i=$((i + 1)); done; done; echo ready at last";
    try (StartedProcess process = started("one", computes)) {
      assertThat(
              process
                  .awaitReady(new StartupTimeout(Duration.ofSeconds(3), LONG), progress)
                  .group(1))
          .isEqualTo("at last");
    }
  }

  @Test
  void waitsForAProcessWhoseDependencyMakesProgress() throws Exception {
    String script = "for i in 1 2 3 4 5 6 7 8; do sleep 0.4; echo step $i; done; read end";
    try (StartedProcess other = started("other", script);
        StartedProcess process = started("one", "sleep 3; echo ready at last; read end")) {
      assertThat(process.awaitReady(new StartupTimeout(SHORT, LONG), progress, other).group(1))
          .isEqualTo("at last");
    }
  }

  @Test
  void reportsTheLastLineOfAProcessWithoutProgress() throws Exception {
    try (StartedProcess process = started("one", "echo stuck in the mud; exec sleep 60")) {
      assertThatThrownBy(() -> process.awaitReady(new StartupTimeout(SHORT, LONG), progress))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("the one is not ready after")
          .hasMessageContaining("stuck in the mud");
    }
  }

  @Test
  void stopsWaitingAfterTheTotalTimeout() throws Exception {
    try (StartedProcess process = started("one", "while sleep 0.1; do echo on and on; done")) {
      assertThatThrownBy(() -> process.awaitReady(new StartupTimeout(LONG, SHORT), progress))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("was not ready within");
    }
  }

  @Test
  void reportsAProcessThatEnds() throws Exception {
    try (StartedProcess process = started("one", "echo no such port; exit 1")) {
      assertThatThrownBy(() -> process.awaitReady(new StartupTimeout(LONG, LONG), progress))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("ended before it was ready")
          .hasMessageContaining("no such port");
    }
  }
}
