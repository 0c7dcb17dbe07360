package org.sitaf.server.storage;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DiskReserveTest {
  private static final long MIB = 1 << 20;
  private static final long MIN_FREE = 32 * MIB;

  @TempDir private Path folder;
  private long freeWithoutReserve = 100 * MIB;

  /** Free bytes of a disk that only holds the reserve and what somebody else wrote. */
  private long free() {
    return freeWithoutReserve - kept().stream().mapToLong(DiskReserveTest::size).sum();
  }

  private static long size(Path file) {
    try {
      return Files.size(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<Path> kept() {
    if (!Files.exists(folder.resolve("reserve"))) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder.resolve("reserve"))) {
      return files.toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private DiskReserve reserve(long minFree) {
    return new DiskReserve(folder.resolve("reserve"), minFree, this::free);
  }

  @Test
  void reserveIsAnEighthOfTheSpaceToKeepFree() {
    DiskReserve reserve = reserve(MIN_FREE);
    reserve.refill();
    reserve.refill();
    assertThat(kept()).hasSize(4).allMatch(file -> size(file) == MIB);
    assertThat(free()).isEqualTo(96 * MIB);
  }

  @Test
  void largestReserveIs16Mib() {
    reserve(1024 * MIB).refill();
    assertThat(kept()).isEmpty();
    freeWithoutReserve = 2048 * MIB;
    reserve(1024 * MIB).refill();
    assertThat(free()).isEqualTo(2032 * MIB);
  }

  @Test
  void partsAreGivenBackOnlyWhileTheyAreNeeded() {
    DiskReserve reserve = reserve(MIN_FREE);
    reserve.refill();
    freeWithoutReserve = 5 * MIB;
    reserve.giveBackIfNeeded();
    assertThat(kept()).hasSize(4);
    freeWithoutReserve = 4 * MIB;
    reserve.giveBackIfNeeded();
    assertThat(kept()).hasSize(3);
    freeWithoutReserve = 3 * MIB + 10;
    reserve.giveBackIfNeeded();
    assertThat(kept()).hasSize(2);
    freeWithoutReserve = 0;
    reserve.giveBackIfNeeded();
    assertThat(kept()).isEmpty();
    reserve.giveBackIfNeeded();
  }

  @Test
  void fullDiskIsNotFilledFurther() {
    DiskReserve reserve = reserve(MIN_FREE);
    freeWithoutReserve = 9 * MIB - 1;
    reserve.refill();
    assertThat(kept()).isEmpty();
    freeWithoutReserve = 10 * MIB;
    reserve.refill();
    assertThat(kept()).hasSize(2);
  }

  @Test
  void nothingIsKeptWithoutACheckOfSpace() {
    DiskReserve reserve = reserve(0);
    reserve.refill();
    freeWithoutReserve = 0;
    reserve.giveBackIfNeeded();
    assertThat(folder.resolve("reserve")).doesNotExist();
  }
}
