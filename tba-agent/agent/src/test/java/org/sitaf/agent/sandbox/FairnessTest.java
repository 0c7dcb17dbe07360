package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.agent.sandbox.Escapes.Bound;
import org.sitaf.agent.sandbox.cgroup.AutomaticGroups;

/**
 * A component that uses all processors does not starve another one. The test compares the processor
 * time that the kernel gave to both in the same period, so that other load on the machine does not
 * matter.
 */
@Tag("slow")
@Timeout(300)
class FairnessTest {
  private static final ProcessLimits LIMITS =
      new ProcessLimits(256, 600, 64, Duration.ofMinutes(5));

  /** Ratio to the time of the hostile component; an even share is 1. */
  private static final double LEAST_SHARE = 0.34;

  @TempDir Path folder;

  @ParameterizedTest(name = "{0} {1} {2}")
  @CsvSource({
    "GROUPS,threads,512",
    "GROUPS,processes,400",
    "WATCH,threads,512",
    "WATCH,processes,100"
  })
  void anotherComponentGetsItsShare(Bound bound, String kind, String number) throws Exception {
    assumeTrue(
        bound == Bound.GROUPS ? bound.groups().sharesCpu() : AutomaticGroups.sharesCpu(),
        "skipped: processor time is not shared on this machine");
    String program = Escapes.compiled("burn", folder).toString();
    int processors = Runtime.getRuntime().availableProcessors();
    Sandbox sandbox = bound.sandbox();
    try (ConfinedProcess hostile = start(sandbox, "hostile", program, kind, number);
        ConfinedProcess other =
            start(sandbox, "other", program, "threads", Integer.toString(processors))) {
      // Both have started all their threads and processes.
      Thread.sleep(2000);
      long hostileBefore = ticks(hostile);
      long otherBefore = ticks(other);
      Thread.sleep(3000);
      double share = (double) (ticks(other) - otherBefore) / (ticks(hostile) - hostileBefore);

      assertThat(share).isGreaterThan(LEAST_SHARE);
    }
  }

  /** As a simulator or compiler that is started ahead; it gets its share as soon as it is used. */
  @Test
  void anIdleProcessLeavesTheProcessorsToOthers() throws Exception {
    assumeTrue(
        Bound.GROUPS.groups().sharesCpu(),
        "skipped: processor time is not shared by control groups on this machine");
    String program = Escapes.compiled("burn", folder).toString();
    String processors = Integer.toString(Runtime.getRuntime().availableProcessors());
    Sandbox sandbox = Bound.GROUPS.sandbox();
    assertThat(sandbox.canIdle()).isTrue();
    try (ConfinedProcess idle = start(sandbox, "idle", program, "threads", processors);
        ConfinedProcess other = start(sandbox, "other", program, "threads", processors)) {
      idle.setIdle(true);
      double idleShare = shareOfFirst(idle, other);
      idle.setIdle(false);

      assertThat(idleShare).isLessThan(0.15);
      assertThat(shareOfFirst(idle, other)).isGreaterThan(LEAST_SHARE);
    }
  }

  private static double shareOfFirst(ConfinedProcess first, ConfinedProcess second)
      throws Exception {
    Thread.sleep(500);
    long firstBefore = ticks(first);
    long secondBefore = ticks(second);
    Thread.sleep(2000);
    return (double) (ticks(first) - firstBefore) / (ticks(second) - secondBefore);
  }

  private ConfinedProcess start(Sandbox sandbox, String name, String... command) throws Exception {
    Path own = Files.createDirectories(folder.resolve(name));
    return sandbox.start(
        Escapes.confinement(own, LIMITS, List.of(command)).reading(List.of(Path.of(command[0]))));
  }

  /** Processor time of a process and its descendants, in clock ticks. */
  private static long ticks(ConfinedProcess process) throws Exception {
    long sum = 0;
    Set<Long> all = new TreeSet<>();
    process.handle().descendants().map(ProcessHandle::pid).forEach(all::add);
    for (long id : new ArrayList<>(all)) {
      String stat = Files.readString(Path.of("/proc", Long.toString(id), "stat"));
      String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
      sum += Long.parseLong(fields[11]) + Long.parseLong(fields[12]);
    }
    return sum;
  }
}
