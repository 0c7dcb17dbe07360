package org.sitaf.cli.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.diagnostic.InvalidInputException;

class UserFilesTest {
  @TempDir private Path folder;

  @Test
  void readsNoHiddenFiles() throws IOException {
    Files.writeString(folder.resolve("activity.yaml"), "name: a");
    Files.writeString(Files.createDirectory(folder.resolve(".git")).resolve("HEAD"), "x");
    assertThat(UserFiles.folder(folder).paths()).containsExactly("activity.yaml");
  }

  /** A sparse file takes no space on the disk, and all of its size in memory. */
  @Test
  void refusesAFolderThatIsLargerThanAnActivity() throws IOException {
    try (RandomAccessFile file = new RandomAccessFile(folder.resolve("large.stl").toFile(), "rw")) {
      file.setLength(1L << 40);
    }
    assertThatThrownBy(() -> UserFiles.folder(folder))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("holds more than 10000 files or 256 MiB");
  }

  @Test
  void refusesLinks() throws IOException {
    Files.createSymbolicLink(folder.resolve("link"), Path.of("/etc/passwd"));
    assertThatThrownBy(() -> UserFiles.folder(folder))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("is a link");
  }
}
