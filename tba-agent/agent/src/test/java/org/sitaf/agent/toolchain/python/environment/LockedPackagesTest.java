package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.digest.Sha256;

/** Environments record their packages, and hold exactly those of a lock. */
@Tag("slow")
class LockedPackagesTest extends PackagesTest {
  private static final String ROBOT = "sitaf-locked-robot";
  private static final String ARM = "sitaf-locked-arm";

  @BeforeEach
  void addRobot() throws Exception {
    assumeTrue(!sandbox.kind().equals(Sandbox.NONE), "skipped: bubblewrap is not available");
    index.add(ROBOT, "sitaf_locked_robot-1.0-py3-none-any.whl", LocalIndex.wheel(ROBOT, "", ARM));
  }

  private byte[] addArm(String version) throws Exception {
    byte[] wheel = LocalIndex.release(ARM, version, "VERSION = '" + version + "'\n");
    index.add(ARM, "sitaf_locked_arm-" + version + "-py3-none-any.whl", wheel);
    return wheel;
  }

  private List<ResolvedPackage> packages(@Nullable ActivityLock lock) throws Exception {
    Path environment = make(List.of(ROBOT), List.of(), lock);
    return environments.packages(environment).stream()
        .filter(each -> each.name().startsWith("sitaf-locked"))
        .toList();
  }

  private ActivityLock resolved() throws Exception {
    Path environment = make(List.of(ROBOT), List.of(), null);
    return new ActivityLock(environments.packages(environment), true);
  }

  // tests/e2e/test_lock.py has the short form.
  @Test
  @Tag("long")
  void aLockKeepsTheReleaseWhenANewerOneAppears() throws Exception {
    byte[] first = addArm("1.0");
    ActivityLock lock = resolved();
    assertThat(lock.packages()).contains(new ResolvedPackage(ARM, "1.0", Sha256.hex(first)));
    addArm("2.0");
    environments = index.environments(Files.createDirectory(directory.resolve("later")), sandbox);

    assertThat(packages(null)).extracting(ResolvedPackage::version).containsExactly("2.0", "1.0");
    assertThat(packages(lock)).extracting(ResolvedPackage::version).containsExactly("1.0", "1.0");
  }

  @Test
  void aReplacedFileIsAnErrorThatSaysWhatToDo() throws Exception {
    addArm("1.0");
    ActivityLock lock = resolved();
    index.add(
        ARM,
        "sitaf_locked_arm-1.0-py3-none-any.whl",
        LocalIndex.release(ARM, "1.0", "VERSION = 'other'\n"));

    assertThatThrownBy(() -> packages(lock))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e -> {
              assertThat(e.diagnostics().get(0).file()).isEqualTo("activity/activity.lock");
              assertThat(e.diagnostics().get(0).message())
                  .contains("sitaf-locked-arm 1.0", "was replaced", "--update");
            });
  }

  @Test
  void aReleaseThatPipTakesForAFileIsAnErrorOfTheLock() {
    ActivityLock lock =
        new ActivityLock(List.of(new ResolvedPackage("arm", "1.0.zip", "0".repeat(64))), false);

    assertThatThrownBy(() -> packages(lock))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e ->
                assertThat(e.diagnostics().get(0).message())
                    .contains("activity.lock lists 'arm==1.0.zip', which is not a package"));
  }
}
