package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;

class PackageToolsTest {
  @TempDir private Path directory;

  private String complaint(ToolResult end) throws Exception {
    return new PackageTools(
            Interpreter.find().orElseThrow(),
            PipSettings.of(Map.of(), directory),
            directory,
            Duration.ofSeconds(90),
            Instant.now(),
            Sandbox.none())
        .errorOf(end);
  }

  @Test
  void reportsAKilledTool() throws Exception {
    assertThat(complaint(new ToolResult(137, "", "\n"))).contains("killed by signal 9");
    assertThat(complaint(new ToolResult(1, "", "")))
        .isEqualTo("it ended with exit code 1 and no message");
  }

  @Test
  void reportsATimeoutWithTheSettingToRaise() throws Exception {
    assertThat(complaint(new ToolResult(ToolResult.TIMED_OUT, "", "")))
        .contains("longer than 90 s", "limits: prepare_s");
  }
}
