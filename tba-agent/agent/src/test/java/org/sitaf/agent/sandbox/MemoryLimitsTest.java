package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.agent.sandbox.Escapes.Bound;
import org.sitaf.agent.sandbox.Escapes.End;

/** A process with a limit of 512 MiB cannot get 3 GB by any way of allocating memory. */
@Tag("slow")
@Timeout(300)
class MemoryLimitsTest {
  private static final ProcessLimits LIMITS =
      new ProcessLimits(512, 64, 256, Duration.ofMinutes(1));
  private static final String EXCEEDED = "it used more than 512 MiB of memory";

  @TempDir static Path programs;
  @TempDir Path folder;

  static Stream<Arguments> ways() {
    List<Arguments> ways = new ArrayList<>();
    for (Bound bound : Bound.values()) {
      for (String way :
          List.of(
              "memfd-written",
              "memfd-mapped",
              "shared",
              "private",
              "children",
              "segments",
              "messages",
              "queues",
              "sockets",
              "files /dev/shm",
              "files /dev",
              "files /tmp",
              "files /",
              "files /run")) {
        // If /tmp is on the disk, the limits of the disk apply.
        if (bound == Bound.GROUPS || !way.equals("files /tmp")) {
          ways.add(Arguments.of(bound, way));
        }
      }
    }
    ways.add(Arguments.of(Bound.GROUPS, "names /tmp"));
    ways.add(Arguments.of(Bound.GROUPS, "names /dev/shm"));
    ways.add(Arguments.of(Bound.WATCH, "names /dev/shm"));
    return ways.stream();
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("ways")
  void stopsTheProcess(Bound bound, String way) throws Exception {
    End end = run(bound, way.split(" "));

    if (bound == Bound.GROUPS) {
      // On a busy machine, a process can take all of it between two measurements of the agent.
      assertThat(end.output()).doesNotContain("TAKEN");
    }
    assertThat(end.exceededLimit().isPresent() || end.output().contains("refused"))
        .as(end.toString())
        .isTrue();
  }

  @ParameterizedTest(name = "{0}")
  @EnumSource(Bound.class)
  void reportsTheExceededLimit(Bound bound) throws Exception {
    assertThat(run(bound, "children").exceededLimit()).contains(EXCEEDED);
    assertThat(run(bound, "shared").exceededLimit()).contains(EXCEEDED);
  }

  @Test
  void reportsTheLimitIfTheKernelKilledTheProcess() throws Exception {
    assertThat(run(Bound.GROUPS, "memfd-written").exceededLimit()).contains(EXCEEDED);
    assertThat(run(Bound.GROUPS, "sockets").exceededLimit()).contains(EXCEEDED);
  }

  /** A tmpfs that bubblewrap makes has no limit of the number of files. */
  @ParameterizedTest(name = "{0}")
  @EnumSource(Bound.class)
  void mountsNoTmpfsOfBubblewrap(Bound bound) throws Exception {
    Path outside = Path.of("/var/tmp/sitaf-test-" + ProcessHandle.current().pid());
    java.nio.file.Files.createDirectories(outside);
    try {
      End end =
          Escapes.run(
              bound.sandbox(),
              Escapes.confinement(
                  outside, LIMITS, List.of("stat", "-f", "-c", "%n %T", "/tmp", "/dev/shm")));

      assertThat(end.output()).contains("/tmp ", "/dev/shm ").doesNotContain("tmpfs");
    } finally {
      new ProcessBuilder("rm", "-rf", outside.toString()).start().waitFor();
    }
  }

  private End run(Bound bound, String... way) throws Exception {
    Path program = Escapes.compiled("memory", programs);
    List<String> command = new ArrayList<>(List.of(program.toString()));
    command.addAll(List.of(way));
    return Escapes.run(
        bound.sandbox(), Escapes.confinement(folder, LIMITS, command).reading(List.of(program)));
  }
}
