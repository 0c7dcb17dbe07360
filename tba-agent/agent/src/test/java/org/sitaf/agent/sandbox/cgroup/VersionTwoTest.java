package org.sitaf.agent.sandbox.cgroup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Control groups in a subtree that systemd delegated. */
@Timeout(300)
class VersionTwoTest {
  private static final GroupLimits LIMITS = new GroupLimits(512L << 20, 64);

  @TempDir Path folder;

  private static String content(Path group, String file) throws IOException {
    return Files.readString(group.resolve(file)).strip();
  }

  private static Path only(ControlGroup group) {
    assertThat(group.entrances()).hasSize(1);
    return group.entrances().get(0).getParent();
  }

  @Test
  void setsTheLimitsOfAGroup() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "cpuset cpu io memory pids");
    ControlGroups groups =
        VersionTwo.takeOver(files, folder, GroupOwner.thisProcess()).orElseThrow();
    Path group = only(groups.create(LIMITS));

    assertThat(groups.description()).isEqualTo("control groups (v2) for cpu, memory, pids");
    assertThat(groups.limitsMemory()).isTrue();
    assertThat(groups.sharesCpu()).isTrue();
    assertThat(content(group, "memory.max")).isEqualTo("536870912");
    assertThat(content(group, "memory.swap.max")).isEqualTo("0");
    assertThat(content(group, "memory.oom.group")).isEqualTo("1");
    assertThat(content(group, "pids.max")).isEqualTo("64");
    assertThat(content(group, "cpu.weight")).isEqualTo("100");
  }

  @Test
  void movesTheAgentIntoASubgroup() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "memory pids");
    Files.writeString(folder.resolve("cgroup.procs"), "11\n12\n");
    assertThat(VersionTwo.takeOver(files, folder, GroupOwner.thisProcess())).isPresent();

    assertThat(files.members(folder)).isEmpty();
    assertThat(files.members(folder.resolve(VersionTwo.SELF))).containsExactly(11L, 12L);
  }

  @Test
  void aSecondAgentSharesTheSubtree() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "memory pids");
    assertThat(VersionTwo.takeOver(files, folder, GroupOwner.thisProcess())).isPresent();
    Hierarchies moved = new Hierarchies(Optional.of(folder.resolve(VersionTwo.SELF)), Map.of());

    assertThat(VersionTwo.find(files, moved, GroupOwner.thisProcess())).isPresent();
  }

  @Test
  void findsNoGroupsWithoutControllers() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "cpuset");

    assertThat(VersionTwo.takeOver(files, folder, GroupOwner.thisProcess())).isEmpty();
  }

  @Test
  void remembersAnOutOfMemoryKillAfterRemoval() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "memory");
    ControlGroup group =
        VersionTwo.takeOver(files, folder, GroupOwner.thisProcess()).orElseThrow().create(LIMITS);
    Path created = only(group);
    assertThat(group.exceededMemory()).isFalse();
    Files.writeString(created.resolve("memory.events"), "oom 1\noom_kill 2\noom_group_kill 1\n");
    Files.writeString(created.resolve("cgroup.procs"), "2147483000\n");
    group.remove();

    assertThat(group.exceededMemory()).isTrue();
    assertThat(created).doesNotExist();
  }

  @Test
  void removesGroupsOfAgentsThatHaveEnded() throws IOException {
    FakeGroupFiles files = new FakeGroupFiles(folder, "memory");
    GroupOwner self = GroupOwner.thisProcess();
    Path gone = folder.resolve(new GroupOwner(self.namespace(), self.id(), "1").nameOf(3));
    Path elsewhere = folder.resolve(new GroupOwner("1", 1, "1").nameOf(3));
    Path own = folder.resolve(self.nameOf(7));
    for (Path group : List.of(gone, elsewhere, own)) {
      files.create(group);
    }
    Files.writeString(gone.resolve("cgroup.procs"), "2147483000\n");
    assertThat(VersionTwo.takeOver(files, folder, self)).isPresent();

    assertThat(gone).doesNotExist();
    assertThat(elsewhere).exists();
    assertThat(own).exists();
  }

  /** Uses the kernel's files, in a hierarchy without controllers. */
  @Test
  void killsAllProcessesOfAGroup() throws Exception {
    Path hierarchy = Path.of("/sys/fs/cgroup/unified");
    assumeTrue(
        Files.isDirectory(hierarchy) && Hierarchies.isWritable(hierarchy),
        "skipped: no writable version 2 hierarchy");
    Path created = hierarchy.resolve(GroupOwner.thisProcess().nameOf(999_999));
    Files.createDirectory(created);
    ControlGroup group = new ControlGroup(new GroupFiles(), List.of(created), null, null);
    Process process =
        new ProcessBuilder(
                "/bin/sh",
                "-c",
                "echo 0 >\"$0\" && echo in && { setsid sleep 100 & } && exec sleep 100",
                group.entrances().get(0).toString())
            .start();
    try {
      assertThat(process.inputReader().readLine()).isEqualTo("in");
      group.remove();

      assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
      assertThat(created).doesNotExist();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void findsTheMountedGroupOfThisProcess() {
    Hierarchies hierarchies =
        Hierarchies.of(
            List.of("5:cpu,cpuacct:/a", "4:memory:/docker/b/c", "0::/system.slice/x.service"),
            List.of(
                "30 20 0:26 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw",
                "31 20 0:27 / /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct",
                "32 20 0:28 /docker/b /sys/fs/cgroup/memory rw shared:1 - cgroup cgroup"
                    + " rw,memory"));

    assertThat(hierarchies.unified())
        .contains(Path.of("/sys/fs/cgroup/unified/system.slice/x.service"));
    assertThat(hierarchies.controllers())
        .containsEntry("cpu", Path.of("/sys/fs/cgroup/cpu,cpuacct/a"))
        .containsEntry("memory", Path.of("/sys/fs/cgroup/memory/c"));
  }

  @Test
  void autogroupsHaveNoEffectInACpuGroup() {
    assertThat(AutomaticGroups.isInNoGroupFor("cpu", List.of("1:cpu,cpuacct:/", "0::/a"))).isTrue();
    assertThat(AutomaticGroups.isInNoGroupFor("cpu", List.of("1:cpu:/a", "0::/"))).isFalse();
    assertThat(AutomaticGroups.isInNoGroupFor("cpu", List.of("0::/"))).isTrue();
    assertThat(AutomaticGroups.isInNoGroupFor("cpu", List.of("0::/user.slice"))).isFalse();
  }
}
