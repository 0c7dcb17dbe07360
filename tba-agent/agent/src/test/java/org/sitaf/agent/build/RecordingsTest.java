package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingsTest {
  @TempDir Path folder;

  @Test
  void keepsTheFilesOfCasesAndNothingElseThatAComponentLeftThere() throws IOException {
    Path from = Files.createDirectory(folder.resolve("from"));
    Path secret = Files.writeString(folder.resolve("secret"), "s");
    Files.writeString(from.resolve("1.glb"), "one");
    Files.writeString(from.resolve("22.glb"), "two");
    Files.writeString(from.resolve("virus.exe"), "v");
    Files.writeString(from.resolve("0.glb"), "zero");
    Files.createSymbolicLink(from.resolve("3.glb"), secret);
    Files.createDirectory(from.resolve("4.glb"));

    Path to = folder.resolve("to/Model");
    Recordings.keep(from, to);

    assertThat(to.resolve("1.glb")).hasContent("one");
    assertThat(to.resolve("22.glb")).hasContent("two");
    try (var kept = Files.list(to)) {
      assertThat(kept).hasSize(2);
    }
  }

  @Test
  void keepsNothingWhereNothingWasRecorded() throws IOException {
    Recordings.keep(folder.resolve("nothing"), folder.resolve("to"));

    assertThat(folder.resolve("to")).doesNotExist();
  }
}
