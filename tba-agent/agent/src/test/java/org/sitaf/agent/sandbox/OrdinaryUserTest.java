package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What holds for root holds for an agent that is started by an ordinary user. */
@Tag("slow")
@Timeout(120)
class OrdinaryUserTest {
  /** Nobody, as Debian numbers it. */
  private static final int USER = 65534;

  private Path programs = Path.of("");
  private Path folder = Path.of("");

  @BeforeEach
  void folders() throws Exception {
    assumeTrue(
        Files.getAttribute(Path.of("/proc/self"), "unix:uid").equals(0),
        "skipped: this user cannot become another; the other tests are an ordinary user's");
    programs = Files.createTempDirectory(Path.of("/var/tmp"), "sitaf-programs");
    folder = Files.createTempDirectory(Path.of("/var/tmp"), "sitaf-ordinary");
    Files.setPosixFilePermissions(programs, PosixFilePermissions.fromString("rwxr-xr-x"));
    Files.setAttribute(folder, "unix:uid", USER);
    assumeTrue(
        ended(List.of("test", "-r", SandboxProgram.folderOf(Sandbox.class).toString()))
            .endsWith("0"),
        "skipped: the classes are not readable for others");
    assumeTrue(
        ended(List.of("bwrap", "--unshare-user", "--ro-bind", "/", "/", "true")).endsWith("0"),
        "skipped: bubblewrap does not work for an ordinary user here");
  }

  @AfterEach
  void remove() throws Exception {
    for (Path path : List.of(programs, folder)) {
      if (path.startsWith("/var/tmp")) {
        new ProcessBuilder("rm", "-rf", path.toString()).start().waitFor();
      }
    }
  }

  private static String ended(List<String> command) throws Exception {
    List<String> words =
        new ArrayList<>(
            List.of("setpriv", "--reuid=" + USER, "--regid=" + USER, "--clear-groups", "--"));
    words.addAll(command);
    Process process =
        new ProcessBuilder(words)
            .directory(new java.io.File("/"))
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes());
    return said + process.waitFor();
  }

  private String confined(String... command) throws Exception {
    return confined(false, command);
  }

  private String confined(boolean unfiltered, String... command) throws Exception {
    List<String> words = new ArrayList<>(SandboxProgram.command(unfiltered));
    words.addAll(List.of(folder.toString(), programs.toString()));
    words.addAll(List.of(command));
    return ended(words);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "memfd-written",
        "memfd-mapped",
        "shared",
        "private",
        "children",
        "segments",
        "messages",
        "queues",
        "sockets",
        "files /dev",
        "files /",
        "files /run"
      })
  void memoryIsBounded(String way) throws Exception {
    List<String> command =
        new ArrayList<>(List.of(Escapes.compiled("memory", programs).toString()));
    command.addAll(List.of(way.split(" ")));
    String said = confined(command.toArray(String[]::new));

    assertThat(said).contains("ended ").doesNotContain("TAKEN");
    assertThat(said).containsAnyOf("refused", "it used more than 512 MiB of memory");
  }

  @Test
  void systemCallsAreRefused() throws Exception {
    String said = confined(Escapes.compiled("calls", programs).toString());

    assertThat(said)
        .contains(
            "\nclone:user 1\n", "\nunshare 1\n", "\nio_uring_setup 38\n", "\nuserfaultfd 38\n")
        .contains("\nclone3 38\n", "\nclone:plain ok\n", "\nthread ok\n")
        .contains("ended 0 within its limits");
  }

  /** What bubblewrap itself closes, where there is no filter. */
  @Test
  void userNamespacesAreClosedWithoutTheFilterToo() throws Exception {
    assumeTrue(
        ended(List.of("bwrap", "--help")).contains("--disable-userns"),
        "skipped: this bubblewrap cannot");
    String said = confined(true, Escapes.compiled("calls", programs).toString());

    assertThat(said)
        .contains("SYSTEM CALLS ARE NOT FILTERED")
        .contains("\nclone:user 28\n", "\nunshare 28\n")
        .contains("ended 0");
  }

  @Test
  void theHostsLackIsSaid() throws Exception {
    assertThat(confined("true"))
        .containsAnyOf("memory is watched from outside: ", "control groups (v2) for ")
        .contains("ended 0");
  }
}
