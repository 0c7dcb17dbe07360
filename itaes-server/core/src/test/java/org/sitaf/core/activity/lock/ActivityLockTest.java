package org.sitaf.core.activity.lock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** The lock of an activity's packages. */
class ActivityLockTest {
  private static final String DIGEST = "0123456789abcdef".repeat(4);
  private static final String OTHER = "fedcba9876543210".repeat(4);
  private static final ResolvedPackage NUMPY = new ResolvedPackage("numpy", "2.4.6", DIGEST);
  private static final ResolvedPackage MATH =
      new ResolvedPackage("org.apache.commons:commons-math3", "3.6.1", DIGEST);

  private static ActivityLock read(String text) {
    return ActivityLock.of(
            FileTree.of(Map.of(ActivityLock.FILE, text.getBytes(StandardCharsets.UTF_8))))
        .orElseThrow();
  }

  @Test
  void readsWhatItWrites() {
    for (boolean complete : new boolean[] {true, false}) {
      ActivityLock lock = new ActivityLock(List.of(MATH, NUMPY), complete);

      assertThat(read(lock.text())).isEqualTo(lock);
    }
    assertThat(read(new ActivityLock(List.of(), true).text()).packages()).isEmpty();
  }

  @Test
  void anActivityMayHaveNone() {
    assertThat(ActivityLock.of(FileTree.of(Map.of()))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "--index-url | 1.0 | is not a package",
        "numpy | 1.0 --pre | is not a version",
        "numpy | 1.0</version> | is not a version",
        "num</artifactId> | 1.0 | is not a package",
      })
  void whatIsNoReleaseReachesNoTool(String name, String version, String message) {
    String text =
        "packages:\n- {name: \"%s\", version: \"%s\", sha256: \"%s\"}\n"
            .formatted(name, version, DIGEST);

    assertThatThrownBy(() -> read(text))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining(ActivityLock.FILE)
        .hasMessageContaining(message);
  }

  @Test
  void reportsAPackageThatIsListedTwice() {
    String entry = "- {name: numpy, version: \"2.4.6\", sha256: \"%s\"}\n".formatted(DIGEST);

    assertThatThrownBy(() -> read("packages:\n" + entry + entry))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("listed twice");
  }

  @Test
  void namesWhatIsNotInTheLock() {
    ActivityLock lock = new ActivityLock(List.of(NUMPY), true);

    assertThat(lock.mismatch(List.of(NUMPY))).isEmpty();
    assertThat(lock.mismatch(List.of()).orElseThrow()).contains("numpy", "not needed", "--update");
    assertThat(lock.mismatch(List.of(NUMPY, MATH)).orElseThrow()).contains("does not list org");
    assertThat(lock.mismatch(List.of(new ResolvedPackage("numpy", "2.4.7", DIGEST))).orElseThrow())
        .contains("numpy 2.4.6", "2.4.7 is needed");
    assertThat(lock.mismatch(List.of(new ResolvedPackage("numpy", "2.4.6", OTHER))).orElseThrow())
        .contains(DIGEST, OTHER, "was replaced");
  }

  @Test
  void saysWhichPackagesChanged() {
    ResolvedPackage later = new ResolvedPackage("numpy", "2.4.7", OTHER);
    ResolvedPackage replaced = new ResolvedPackage(MATH.name(), "3.6.1", OTHER);

    assertThat(PackageChanges.between(List.of(NUMPY, MATH), List.of(later, MATH)))
        .containsExactly("numpy 2.4.6 -> 2.4.7");
    assertThat(PackageChanges.between(List.of(NUMPY, MATH), List.of(replaced)))
        .containsExactly("numpy is no longer used", MATH.name() + " 3.6.1, another file");
    assertThat(PackageChanges.between(List.of(), List.of(NUMPY))).containsExactly("numpy 2.4.6");
  }

  @Test
  void leavesOnePackageOpen() {
    ActivityLock lock = new ActivityLock(List.of(NUMPY, MATH), true).without("numpy");

    assertThat(lock.mismatch(List.of(MATH, new ResolvedPackage("numpy", "1.0", OTHER)))).isEmpty();
    assertThat(lock.mismatch(List.of(new ResolvedPackage(MATH.name(), "3.6", DIGEST)))).isPresent();
  }
}
