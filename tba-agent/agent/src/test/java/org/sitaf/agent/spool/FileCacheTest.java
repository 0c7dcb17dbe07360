package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileCacheTest {
  /** Digest of "abc", from FIPS 180-4. */
  private static final String ABC =
      "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

  @TempDir private Path directory;

  @Test
  void findsAFileByItsDigest() throws Exception {
    FileCache cache = FileCache.open(directory);
    assertThat(cache.find(ABC)).isEmpty();
    cache.add(ABC, out -> out.write(new byte[] {'a', 'b', 'c'}));

    assertThat(FileCache.open(directory).find(ABC)).hasValue(new byte[] {'a', 'b', 'c'});
  }

  @Test
  void rejectsAFileThatDoesNotMatchItsDigest() throws Exception {
    FileCache cache = FileCache.open(directory);

    assertThatThrownBy(() -> cache.add(ABC, out -> out.write('x')))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("expected " + ABC);
    assertThat(directory).isEmptyDirectory();
  }

  @Test
  void removesADamagedFile() throws Exception {
    FileCache cache = FileCache.open(directory);
    cache.add(ABC, out -> out.write(new byte[] {'a', 'b', 'c'}));
    Files.writeString(directory.resolve(ABC), "abd");

    assertThat(cache.find(ABC)).isEmpty();
  }

  @Test
  void rejectsAPathAsDigest() throws Exception {
    FileCache cache = FileCache.open(directory);

    assertThatThrownBy(() -> cache.find("../" + ABC.substring(3)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
