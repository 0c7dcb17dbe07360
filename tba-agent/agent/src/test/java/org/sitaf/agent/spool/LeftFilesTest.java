package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.OddTrees;

@Timeout(300)
class LeftFilesTest {
  @TempDir private Path directory;

  private List<Path> data(int most) throws IOException {
    return LeftFiles.in(directory, file -> file.toString().endsWith(".data"), most);
  }

  @Test
  void findsRegularFilesUpToALimitedDepth() throws Exception {
    Path secret = Files.writeString(directory.resolve("secret"), "x");
    Path file = Files.writeString(directory.resolve("a.data"), "x");
    Files.createSymbolicLink(directory.resolve("b.data"), secret);
    Files.createDirectory(directory.resolve("c.data"));
    SystemTool.run(
        List.of("mkfifo", directory.resolve("d.data").toString()), Duration.ofSeconds(5));
    Files.createSymbolicLink(directory.resolve("up"), directory);
    OddTrees.createNestedFolders(directory, 500);

    assertThat(data(10)).containsExactly(file);
    assertThatThrownBy(() -> LeftFiles.read(directory.resolve("b.data"), 10))
        .hasMessage("b.data is not a regular file");
    assertThatThrownBy(() -> LeftFiles.read(directory.resolve("d.data"), 10))
        .hasMessage("d.data is not a regular file");
    Folders.delete(directory);
  }

  @Test
  void rejectsTooManyAndTooLongFiles() throws Exception {
    for (int i = 0; i < 3; i++) {
      Files.write(directory.resolve(i + ".data"), new byte[11]);
    }

    assertThat(data(3)).hasSize(3);
    assertThatThrownBy(() -> data(2)).hasMessage("there are more than 2 files of this kind");
    assertThat(LeftFiles.read(directory.resolve("0.data"), 11)).hasSize(11);
    assertThatThrownBy(() -> LeftFiles.read(directory.resolve("0.data"), 10))
        .hasMessage("0.data has more than 10 bytes");
  }
}
