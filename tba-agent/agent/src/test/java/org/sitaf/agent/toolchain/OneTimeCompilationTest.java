package org.sitaf.agent.toolchain;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OneTimeCompilationTest {
  @Test
  void reportsItsBeginAndItsFiles(@TempDir Path folder) throws Exception {
    Files.createDirectory(folder.resolve("objects"));
    Files.createFile(folder.resolve("objects/0.o"));
    Files.createFile(folder.resolve("all.hpp.gch"));
    Files.createFile(folder.resolve("0.d"));
    BlockingQueue<String> reports = new LinkedBlockingQueue<>();

    try (OneTimeCompilation compilation =
        OneTimeCompilation.of(reports::add, "the runtime", folder, 7, Duration.ofMillis(1))) {
      assertThat(compilation).isNotNull();
      assertThat(reports.poll(10, TimeUnit.SECONDS))
          .isEqualTo("compiling the runtime, once on this machine");
      assertThat(reports.poll(10, TimeUnit.SECONDS))
          .isEqualTo("compiling the runtime: 2 of 7 files");
    }
  }
}
