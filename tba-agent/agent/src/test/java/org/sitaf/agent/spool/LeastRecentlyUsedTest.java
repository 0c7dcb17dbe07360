package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LeastRecentlyUsedTest {
  @TempDir private Path directory;
  private final List<Path> entries = new ArrayList<>();

  /** Entries that were used one after the other. */
  private void entries(int... sizes) throws IOException {
    for (int size : sizes) {
      Path entry = Files.write(directory.resolve("e" + entries.size()), new byte[size]);
      Files.setLastModifiedTime(entry, FileTime.fromMillis(1_000_000L + 1000L * entries.size()));
      entries.add(entry);
    }
  }

  private List<String> left(LeastRecentlyUsed bounds) throws IOException {
    bounds.shrink(entries, entry -> entry.toFile().length(), Files::deleteIfExists);
    return entries.stream()
        .filter(Files::exists)
        .map(entry -> entry.getFileName().toString())
        .toList();
  }

  @Test
  void deletesTheLeastRecentlyUsedEntryFirst() throws IOException {
    entries(10, 10, 10, 10);
    LeastRecentlyUsed.touch(entries.get(0));

    assertThat(left(new LeastRecentlyUsed(25, 100))).containsExactly("e0", "e3");
  }

  @Test
  void limitsTheNumberOfEntries() throws IOException {
    entries(1, 1, 1);

    assertThat(left(new LeastRecentlyUsed(1000, 2))).containsExactly("e1", "e2");
  }

  @Test
  void keepsTheMostRecentlyUsedEntryOfAnySize() throws IOException {
    entries(1, 500);

    assertThat(left(new LeastRecentlyUsed(100, 10))).containsExactly("e1");
  }
}
