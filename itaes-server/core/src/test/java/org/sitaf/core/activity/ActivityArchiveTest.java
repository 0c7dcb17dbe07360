package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Archives of users are untrusted: their unpacked size is limited, and truncation is reported. */
class ActivityArchiveTest {
  private static final int MIB = 1 << 20;

  @Test
  void rejectsAnArchiveThatUnpacksToTooManyBytes() throws IOException {
    byte[] zip = zip("zeros", new byte[64 * MIB]);
    assertThat(zip.length).isLessThan(100_000);
    assertThatThrownBy(() -> read(zip, ActivityArchive.MAX_SIZE))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("unpacks to more than 100 times its size")
        .hasMessageContaining("KiB");
  }

  @Test
  void countsTheContentOfFolderEntries() throws IOException {
    byte[] zip = zip("folder/", new byte[64 * MIB]);
    assertThatThrownBy(() -> read(zip, ActivityArchive.MAX_SIZE))
        .hasMessageContaining("100 times its size");
  }

  @Test
  void acceptsSmallZeroFilledAndLargeRandomContent() throws IOException {
    assertThat(read(zip("zeros", new byte[MIB]), ActivityArchive.MAX_SIZE).size()).isEqualTo(MIB);
    byte[] noise = new byte[3 * MIB];
    new Random(1).nextBytes(noise);
    FileTree tree = read(zip("noise", noise), ActivityArchive.MAX_SIZE);
    assertThat(tree.content("noise")).hasValueSatisfying(c -> assertThat(c).isEqualTo(noise));
    assertThatThrownBy(() -> read(zip("noise", noise), 2 * MIB))
        .hasMessageContaining("more than 2 MiB");
  }

  @Test
  void reportsATruncatedArchive() throws IOException {
    byte[] noise = new byte[MIB];
    new Random(1).nextBytes(noise);
    byte[] zip = zip("noise", noise);
    for (int length : new int[] {0, 10, 40, 1000, MIB / 2}) {
      assertThatThrownBy(() -> read(Arrays.copyOf(zip, length), ActivityArchive.MAX_SIZE))
          .isInstanceOf(InvalidInputException.class);
    }
  }

  @Test
  void rejectsInvalidPathsAndShortensThemInMessages() {
    for (String path :
        new String[] {
          "a/".repeat(60) + "x", "ü".repeat(150), "a\u202eb", "a\u2028b", "x".repeat(60_000)
        }) {
      assertThatThrownBy(() -> FileTree.requireSafe(path))
          .isInstanceOf(IllegalArgumentException.class)
          .satisfies(e -> assertThat(e.getMessage().length()).isLessThan(300))
          .satisfies(e -> assertThat(e.getMessage()).doesNotContain("\u202e", "\u2028"));
    }
    assertThat(FileTree.requireSafe("größe/模型.xml")).isEqualTo("größe/模型.xml");
  }

  private static FileTree read(byte[] zip, long maxSize) {
    return ActivityArchive.read(new ByteArrayInputStream(zip), "the archive", maxSize);
  }

  private static byte[] zip(String name, byte[] content) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry(name));
      zip.write(content);
      zip.closeEntry();
    }
    return bytes.toByteArray();
  }
}
