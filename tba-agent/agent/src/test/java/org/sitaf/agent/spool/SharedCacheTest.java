package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Agents and commands share a cache without locks. */
class SharedCacheTest {
  @TempDir private Path folder;

  @Test
  void theFirstOfSeveralEntriesStays() throws IOException {
    SharedCache cache = new SharedCache(folder);
    try (SharedCache.Draft first = cache.draft();
        SharedCache.Draft second = cache.draft()) {
      Files.writeString(first.folder().resolve("content"), "first");
      Files.writeString(second.folder().resolve("content"), "second");
      first.addAs("entry");
      second.addAs("entry");
    }
    assertThat(cache.entry("entry").resolve("content")).hasContent("first");
    assertThat(names()).containsExactly("entry");
  }

  @Test
  void anEntryOfTheEarlierCacheIsUsedUnlessThereIsAnother() throws IOException {
    Path earlier = Files.createDirectory(folder.resolve("earlier"));
    Files.createDirectory(earlier.resolve("entry"));
    SharedCache cache = new SharedCache(folder.resolve("own"), earlier);

    assertThat(cache.existing("entry")).contains(earlier.resolve("entry"));
    assertThat(cache.existing("other")).isEmpty();
    try (SharedCache.Draft draft = cache.draft()) {
      draft.addAs("entry");
    }
    assertThat(cache.existing("entry")).contains(folder.resolve("own").resolve("entry"));
    assertThat(earlier.resolve("entry")).isEmptyDirectory();
  }

  @Test
  void manyAddTheSameEntryAtOnce() throws Exception {
    int threads = 8;
    ExecutorService all = Executors.newFixedThreadPool(threads);
    try {
      for (int round = 0; round < 20; round++) {
        String name = "entry" + round;
        CyclicBarrier together = new CyclicBarrier(threads);
        List<Future<Void>> ends = new ArrayList<>();
        for (int i = 0; i < threads; i++) {
          ends.add(
              all.submit(
                  () -> {
                    SharedCache cache = new SharedCache(folder);
                    try (SharedCache.Draft draft = cache.draft()) {
                      Files.writeString(draft.folder().resolve("content"), name);
                      together.await();
                      draft.addAs(name);
                      assertThat(cache.entry(name).resolve("content")).hasContent(name);
                    }
                    return null;
                  }));
        }
        for (Future<Void> end : ends) {
          end.get();
        }
        assertThat(names()).hasSize(round + 1);
      }
    } finally {
      all.shutdownNow();
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.map(entry -> entry.getFileName().toString()).toList();
    }
  }
}
