package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Two agents of one host never use the same user id. */
@Tag("slow")
@Timeout(300)
class SandboxUsersTest {
  /** Ids that no agent uses: claiming a range kills the processes of its users. */
  private static final int FIRST = 990_000;

  @TempDir Path claims;

  @Test
  void eachClaimGetsItsOwnRange() throws IOException {
    SandboxUsers one = SandboxUsers.claim(claims, FIRST, 10, 2);
    SandboxUsers two = SandboxUsers.claim(claims, FIRST, 10, 2);

    assertThat(one.first()).isEqualTo(FIRST);
    assertThat(one.last()).isEqualTo(FIRST + 9);
    assertThat(two.first()).isEqualTo(FIRST + 10);
    assertThatThrownBy(() -> SandboxUsers.claim(claims, FIRST, 10, 2))
        .hasMessageContaining("all 2 ranges of sandbox users are in use, see " + claims);
  }

  @Test
  void anotherProcessSeesTheClaim() throws Exception {
    SandboxUsers own = SandboxUsers.claim(claims, FIRST, 10, 2);
    Process other =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                SandboxProgram.folderOf(Sandbox.class) + ":" + SandboxProgram.folderOf(Claim.class),
                Claim.class.getName(),
                claims.toString())
            .redirectErrorStream(true)
            .start();

    assertThat(new String(other.getInputStream().readAllBytes()).strip())
        .isEqualTo(Integer.toString(own.first() + 10));
  }

  /** Another agent. */
  static final class Claim {
    private Claim() {}

    public static void main(String[] arguments) throws IOException {
      System.out.println(SandboxUsers.claim(Path.of(arguments[0]), FIRST, 10, 2).first());
    }
  }

  @Test
  void doesNotAssignAUserTwice() throws IOException {
    SandboxUsers users = SandboxUsers.claim(claims, FIRST, 3, 1);
    int first = users.acquire();
    int second = users.acquire();
    int third = users.acquire();
    assertThatThrownBy(users::acquire).hasMessageContaining("more than 3 confined processes");
    users.release(second);

    assertThat(users.acquire()).isEqualTo(second);
    assertThat(first).isNotEqualTo(third);
  }

  @Test
  void killsProcessesOfAUserBeforeItIsReused() throws Exception {
    assumeTrue(isRoot(), "skipped: this user cannot become another");
    SandboxUsers users = SandboxUsers.claim(claims, FIRST + 20, 2, 1);
    int user = users.acquire();
    Process left =
        new ProcessBuilder("setpriv", "--reuid=" + user, "--clear-groups", "sleep", "50").start();
    waitForUser(left, user);
    int kept = users.acquire();
    Process busy =
        new ProcessBuilder("setpriv", "--reuid=" + kept, "--clear-groups", "sleep", "50").start();
    waitForUser(busy, kept);
    try {
      users.release(user);

      assertThat(users.acquire()).isEqualTo(user);
      assertThat(left.waitFor(60, TimeUnit.SECONDS)).isTrue();
      assertThat(busy.isAlive()).isTrue();
    } finally {
      busy.destroyForcibly();
      left.destroyForcibly();
    }
  }

  private static void waitForUser(Process process, int user) throws Exception {
    Path status = Path.of("/proc", Long.toString(process.pid()));
    while (!java.nio.file.Files.getAttribute(status, "unix:uid").equals(user)) {
      Thread.sleep(5);
    }
  }

  private static boolean isRoot() throws IOException {
    return java.nio.file.Files.getAttribute(Path.of("/proc/self"), "unix:uid").equals(0);
  }
}
