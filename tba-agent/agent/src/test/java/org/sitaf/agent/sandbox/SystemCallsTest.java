package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.agent.sandbox.Escapes.Bound;
import org.sitaf.agent.sandbox.Escapes.End;

/** The filter blocks system calls that help to escape and allows those that programs need. */
@Tag("slow")
@Timeout(300)
class SystemCallsTest {
  private static final Set<String> NEEDED =
      Set.of(
          "clone:plain",
          "thread",
          "personality:ask",
          "socket:netlink-route",
          "socket:unix",
          "socket:inet",
          "socket:inet6",
          "socketpair:unix");

  /** Allowed only if a control group counts their memory. */
  private static final Set<String> COUNTED = Set.of("memfd_create", "shmget");

  private static final String EPERM = "1";
  private static final String ENOSYS = "38";
  private static final String EAFNOSUPPORT = "97";

  @TempDir Path folder;

  private Map<String, String> answers(Bound bound) throws Exception {
    End end = run(bound, List.of(Escapes.compiled("calls", folder).toString()));
    assertThat(end.code()).as(end.toString()).isZero();
    Map<String, String> answers = new TreeMap<>();
    end.output()
        .lines()
        .forEach(line -> answers.put(line.split(" ")[0], line.substring(line.indexOf(' ') + 1)));
    return answers;
  }

  private End run(Bound bound, List<String> command) throws Exception {
    return Escapes.run(bound.sandbox(), Escapes.confinement(folder, ProcessLimits.TOOL, command));
  }

  @ParameterizedTest(name = "{0}")
  @EnumSource(Bound.class)
  void blocksDangerousCalls(Bound bound) throws Exception {
    Map<String, String> answers = answers(bound);
    Set<String> open = new TreeSet<>();
    answers.forEach(
        (call, answer) -> {
          if (!Set.of(EPERM, ENOSYS, EAFNOSUPPORT).contains(answer)) {
            open.add(call);
          }
        });
    Set<String> expected = new TreeSet<>(NEEDED);
    if (bound == Bound.GROUPS) {
      expected.addAll(COUNTED);
    }

    assertThat(answers).hasSizeGreaterThan(75);
    assertThat(open).isEqualTo(expected);
    assertThat(answers)
        .containsEntry("unshare", EPERM)
        .containsEntry("clone:user", EPERM)
        .containsEntry("clone3", ENOSYS)
        .containsEntry("io_uring_setup", ENOSYS)
        .containsEntry("userfaultfd", ENOSYS)
        .containsEntry("ioctl:TIOCSTI", EPERM)
        .containsEntry("socket:vsock", EAFNOSUPPORT);
  }

  @Test
  void filterCannotBeRemoved() throws Exception {
    End end =
        run(Bound.WATCH, List.of("grep", "-E", "^(Seccomp|NoNewPrivs):", "/proc/self/status"));

    assertThat(end.output()).isEqualTo("NoNewPrivs:\t1\nSeccomp:\t2\n");
  }

  @ParameterizedTest(name = "{0}")
  @EnumSource(Bound.class)
  void noDescriptorOfTheAgentIsInherited(Bound bound) throws Exception {
    End end = run(bound, List.of("sh", "-c", "ls -l /proc/$$/fd"));

    assertThat(end.output().lines().filter(line -> line.contains("->")))
        .hasSize(3)
        .allMatch(line -> line.contains("pipe:"));
  }

  /** Programs that set up the sandbox must not load a library of the component. */
  @Test
  void onlyTheComponentSeesItsVariables() throws Exception {
    Path libraries = Files.createDirectories(folder.resolve("libraries"));
    Path library = Escapes.compiled("library", folder, "-shared", "-fPIC");
    for (String name : List.of("libcap.so.2", "libselinux.so.1", "libcap-ng.so.0")) {
      Files.copy(library, libraries.resolve(name));
    }
    Path mark = folder.resolve("mark");
    Confinement confinement =
        Escapes.confinement(folder, ProcessLimits.TOOL, List.of("sh", "-c", "echo $MARK"))
            .withEnvironment(
                Map.of("LD_LIBRARY_PATH", libraries.toString(), "MARK", mark.toString()));
    End end = Escapes.run(Bound.WATCH.sandbox(), confinement);

    assertThat(end.output()).isEqualTo(mark + "\n");
    assertThat(mark).doesNotExist();
  }
}
