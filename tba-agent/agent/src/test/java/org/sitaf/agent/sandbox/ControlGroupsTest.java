package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Escapes.Bound;
import org.sitaf.agent.sandbox.Escapes.End;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;
import org.sitaf.agent.sandbox.cgroup.ControlGroups;

/** Each confined process has a control group, which is removed after its end. */
@Tag("slow")
@Timeout(300)
class ControlGroupsTest {
  private static final ProcessLimits LIMITS = new ProcessLimits(256, 32, 64, Duration.ofMinutes(1));

  @TempDir Path folder;

  /**
   * The groups that a process has now. Tests of this class compare with those before them: other
   * classes in the same process keep some, such as that of a bridge that was started ahead.
   */
  private static List<Path> groupsOf(long process) throws Exception {
    ControlGroups groups = ControlGroups.ofThisMachine();
    ControlGroup sample =
        groups.create(new org.sitaf.agent.sandbox.cgroup.GroupLimits(64 << 20, 8));
    List<Path> found = new ArrayList<>();
    for (Path entrance : sample.entrances()) {
      try (Stream<Path> siblings = Files.list(entrance.getParent().getParent())) {
        siblings
            .filter(p -> p.getFileName().toString().matches("sitaf-\\d+-" + process + "-.*"))
            .filter(p -> !p.equals(entrance.getParent()))
            .forEach(found::add);
      }
    }
    sample.remove();
    return found;
  }

  private static long self() {
    return ProcessHandle.current().pid();
  }

  @Test
  void removesTheGroupAfterTheEnd() throws Exception {
    Sandbox sandbox = Bound.GROUPS.sandbox();
    Confinement confinement =
        Escapes.confinement(
            folder, LIMITS, List.of("sh", "-c", "setsid sleep 100 & sleep 0.1; echo out"));
    List<Path> before = groupsOf(self());
    ConfinedProcess process = sandbox.start(confinement);
    List<Path> own = groupsOf(self());
    own.removeAll(before);
    assertThat(own).isNotEmpty();
    ToolResult end = ToolResult.of(process, Duration.ofSeconds(20));

    assertThat(end.output()).isEqualTo("out\n");
    assertThat(groupsOf(self())).doesNotContainAnyElementsOf(own);
  }

  @Test
  void removesTheGroupOfAKilledProcess() throws Exception {
    List<Path> before = groupsOf(self());
    ConfinedProcess process =
        Bound.GROUPS.sandbox().start(Escapes.confinement(folder, LIMITS, List.of("sleep", "100")));
    List<Path> own = groupsOf(self());
    own.removeAll(before);
    assertThat(own).isNotEmpty();
    process.kill();
    process.close();

    assertThat(groupsOf(self())).doesNotContainAnyElementsOf(own);
  }

  @Test
  void limitsTheNumberOfProcessesOfTheWholeTree() throws Exception {
    End end =
        Escapes.run(
            Bound.GROUPS.sandbox(),
            Escapes.confinement(
                folder,
                LIMITS,
                List.of(
                    "python3",
                    "-c",
                    """
                    import os, time
                    n = 0
                    try:
                        for n in range(100):
                            if os.fork() == 0:
                                time.sleep(20)
                                os._exit(0)
                    except OSError as e:
                        print(n, e.errno)
                    """)));

    assertThat(end.output()).matches("(2\\d|3[0-2]) 11\n");
  }

  @Test
  void removesGroupsOfAKilledAgent() throws Exception {
    assumeTrue(Bound.GROUPS.groups().limitsMemory(), Bound.GROUPS.groups().description());
    Process agent = startAgent("sleep", "100");
    long id = agent.pid();
    BufferedReader output = new BufferedReader(new InputStreamReader(agent.getInputStream()));
    assertThat(output.readLine()).contains("control groups");
    while (groupsOf(id).isEmpty()) {
      Thread.sleep(20);
    }
    agent.destroyForcibly().waitFor();
    assertThat(groupsOf(id)).isNotEmpty();
    Process next = startAgent("true");
    assertThat(new String(next.getInputStream().readAllBytes())).contains("ended 0");

    assertThat(groupsOf(id)).isEmpty();
  }

  private Process startAgent(String... command) throws Exception {
    List<String> words = new ArrayList<>(SandboxProgram.command());
    words.addAll(List.of(folder.toString(), "/usr"));
    words.addAll(List.of(command));
    return new ProcessBuilder(words).redirectErrorStream(true).start();
  }

  @Test
  void describesMissingFeatures() throws Exception {
    ControlGroups none = ControlGroups.none("no group is delegated");
    assumeTrue(!SandboxMode.AUTO.open().kind().equals(Sandbox.NONE), "skipped: no bubblewrap");

    assertThat(Bubblewrap.find(true, none, true).description())
        .contains("the agent polls the memory in use: no group is delegated");
    assertThat(Bubblewrap.find(false, none, false).description())
        .contains("MEMORY IS NOT LIMITED: no group is delegated", "SYSTEM CALLS ARE NOT FILTERED");
    assertThatThrownBy(() -> Bubblewrap.find(true, none, false))
        .isInstanceOf(SandboxMissingException.class)
        .hasMessageContaining("the memory of components cannot be limited: no group is delegated");
  }
}
