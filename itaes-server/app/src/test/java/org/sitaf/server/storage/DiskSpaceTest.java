package org.sitaf.server.storage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.util.unit.DataSize;

class DiskSpaceTest {
  private static final Path DATA = Path.of("/data/sitaf");

  private static DiskSpace disk(long minFreeMib, Map<Path, Long> freeMib) {
    return disk(minFreeMib, true, freeMib);
  }

  private static DiskSpace disk(long minFreeMib, boolean holdsDatabase, Map<Path, Long> freeMib) {
    DataSize anySize = DataSize.ofMegabytes(1);
    SitafSettings settings =
        new SitafSettings(
            DATA,
            null,
            List.of(),
            List.of(),
            Duration.ofSeconds(15),
            3,
            Duration.ofSeconds(1),
            anySize,
            anySize,
            anySize,
            anySize,
            DataSize.ofMegabytes(minFreeMib),
            false);
    return new DiskSpace(
        settings,
        holdsDatabase,
        folder -> DataSize.ofMegabytes(freeMib.getOrDefault(folder, 0L)).toBytes());
  }

  @Test
  void newWorkIsAcceptedWithEnoughSpace() {
    DiskSpace disk = disk(256, Map.of(DATA, 256L));
    assertThat(disk.whyNoNewWork()).isEmpty();
    assertThat(disk.canWrite()).isTrue();
    assertThatCode(disk::requireForNewWork).doesNotThrowAnyException();
  }

  @Test
  void onlyNewWorkIsRejectedWithLittleSpace() {
    DiskSpace disk = disk(256, Map.of(DATA, 255L));
    assertThat(disk.whyNoNewWork())
        .contains("the disk of the server's data has only 255 MiB left, 256 MiB are required");
    assertThat(disk.canWrite()).isTrue();
    assertThatThrownBy(disk::requireForNewWork)
        .isInstanceOfSatisfying(
            RequestException.class,
            e -> assertThat(e.reason()).isEqualTo(RequestException.Reason.DISK_FULL))
        .hasMessageStartingWith(
            "The server accepts no new work: the disk of the server's data has only");
  }

  @Test
  void nothingIsWrittenBelowTheReserve() {
    DiskSpace disk = disk(256, Map.of(DATA, 63L));
    assertThat(disk.whyNothingIsWritten()).isPresent();
    assertThat(disk.canWrite()).isFalse();
  }

  @Test
  void largeContentMustLeaveTheReserve() {
    DiskSpace disk = disk(256, Map.of(DATA, 100L));
    assertThatCode(() -> disk.requireFor(DataSize.ofMegabytes(36).toBytes()))
        .doesNotThrowAnyException();
    assertThatThrownBy(() -> disk.requireFor(DataSize.ofMegabytes(37).toBytes()))
        .isInstanceOf(RequestException.class)
        .hasMessageContaining("100 MiB left, 101 MiB are required");
  }

  @Test
  void remoteDatabaseIsWrittenRegardlessOfLocalSpace() {
    DiskSpace disk = disk(256, false, Map.of(DATA, 0L));
    assertThat(disk.whyNoNewWork()).isPresent();
    assertThat(disk.canWrite()).isTrue();
  }

  @Test
  void minFreeOfZeroDisablesTheCheck() {
    DiskSpace disk = disk(0, Map.of());
    assertThat(disk.whyNoNewWork()).isEmpty();
    assertThat(disk.canWrite()).isTrue();
    assertThatCode(() -> disk.requireFor(1)).doesNotThrowAnyException();
  }
}
