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

/** The sandbox works for an agent that an unprivileged user started. */
@Tag("slow")
@Timeout(300)
class OrdinaryUserTest {
  /** The user id of {@code nobody} in Debian. */
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
        run(List.of("test", "-r", SandboxProgram.folderOf(Sandbox.class).toString())).endsWith("0"),
        "skipped: the classes are not readable for others");
    assumeTrue(
        run(List.of("bwrap", "--unshare-user", "--ro-bind", "/", "/", "true")).endsWith("0"),
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

  private static String run(List<String> command) throws Exception {
    List<String> words =
        new ArrayList<>(
            List.of("setpriv", "--reuid=" + USER, "--regid=" + USER, "--clear-groups", "--"));
    words.addAll(command);
    Process process =
        new ProcessBuilder(words)
            .directory(new java.io.File("/"))
            .redirectErrorStream(true)
            .start();
    String output = new String(process.getInputStream().readAllBytes());
    return output + process.waitFor();
  }

  private String confined(String... command) throws Exception {
    return confined(false, command);
  }

  private String confined(boolean unfiltered, String... command) throws Exception {
    List<String> words = new ArrayList<>(SandboxProgram.command(unfiltered));
    words.addAll(List.of(folder.toString(), programs.toString()));
    words.addAll(List.of(command));
    return run(words);
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
  void limitsMemory(String way) throws Exception {
    List<String> command =
        new ArrayList<>(List.of(Escapes.compiled("memory", programs).toString()));
    command.addAll(List.of(way.split(" ")));
    String output = confined(command.toArray(String[]::new));

    // On a busy machine, a process can take all of it between two measurements of the agent.
    assertThat(output).contains("ended ");
    assertThat(output).containsAnyOf("refused", "it used more than 512 MiB of memory");
  }

  @Test
  void blocksSystemCalls() throws Exception {
    String output = confined(Escapes.compiled("calls", programs).toString());

    assertThat(output)
        .contains(
            "\nclone:user 1\n", "\nunshare 1\n", "\nio_uring_setup 38\n", "\nuserfaultfd 38\n")
        .contains("\nclone3 38\n", "\nclone:plain ok\n", "\nthread ok\n")
        .contains("ended 0 within its limits");
  }

  /** Without the filter, bubblewrap itself blocks user namespaces. */
  @Test
  void blocksUserNamespacesWithoutTheFilter() throws Exception {
    assumeTrue(
        run(List.of("bwrap", "--help")).contains("--disable-userns"),
        "skipped: this bubblewrap has no --disable-userns");
    String output = confined(true, Escapes.compiled("calls", programs).toString());

    assertThat(output)
        .contains("SYSTEM CALLS ARE NOT FILTERED")
        .contains("\nclone:user 28\n", "\nunshare 28\n")
        .contains("ended 0");
  }

  /** It is the parent of the component, has its user, and reports its exit code. */
  @ParameterizedTest
  @ValueSource(strings = {"environ", "maps", "mem", "root/", "fd/2"})
  void protectsTheFirstProcess(String name) throws Exception {
    String output =
        confined(
            "sh", "-c", "grep Name /proc/1/status; ls /proc/1/" + name + " && cat /proc/1/" + name);
    assumeTrue(!output.contains("FIRST PROCESS IS NOT PROTECTED"), "skipped: no Landlock here");

    assertThat(output)
        .contains("Name:\tbwrap")
        .contains("ermission denied")
        .doesNotContain("ended 0");
  }

  @Test
  void describesTheFeaturesOfTheHost() throws Exception {
    assertThat(confined("true"))
        .containsAnyOf("the agent polls the memory in use: ", "control groups (v2) for ")
        .contains("ended 0");
  }
}
