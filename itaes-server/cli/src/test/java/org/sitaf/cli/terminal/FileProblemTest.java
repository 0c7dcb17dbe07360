package org.sitaf.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A path alone says nothing. */
class FileProblemTest {
  @TempDir private Path folder;

  @Test
  void saysWhatHappenedToAFile() throws IOException {
    Path missing = folder.resolve("missing");
    Path full = Files.createDirectories(folder.resolve("full/inner")).getParent();
    Path file = Files.createFile(folder.resolve("file"));

    assertThat(FileProblem.of(catchThrowable(() -> Files.size(missing))))
        .isEqualTo(missing + ": does not exist");
    assertThat(FileProblem.of(catchThrowable(() -> Files.createDirectory(full))))
        .isEqualTo(full + ": exists already");
    assertThat(FileProblem.of(catchThrowable(() -> Files.delete(full))))
        .isEqualTo(full + ": the folder is not empty");
    assertThat(FileProblem.of(catchThrowable(() -> Files.newDirectoryStream(file).close())))
        .isEqualTo(file + ": is not a folder");
  }

  @Test
  void keepsReasonsAndMessages() {
    IOException withReason = new java.nio.file.FileSystemException("a", null, "No space left");
    assertThat(FileProblem.of(new UncheckedIOException(withReason))).isEqualTo("a: No space left");
    assertThat(FileProblem.of(new IOException("the connection was lost")))
        .isEqualTo("the connection was lost");
    assertThat(FileProblem.of(new IOException())).isEqualTo("IOException");
  }
}
