package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** Probes, once per process, which control groups this process may create. */
final class ControlGroupProbe {
  /** Advice for a user whose agent has none. */
  private static final String ADVICE =
      "start the agent by its systemd unit (Delegate=yes), by 'systemd-run --user --scope -p"
          + " Delegate=yes' or, with control groups v1, as root";

  private static final long PROBE_SECONDS = 10;
  private static final GroupLimits PROBE = new GroupLimits(64L << 20, 16);

  private static @Nullable ControlGroups found;

  private ControlGroupProbe() {}

  static synchronized ControlGroups groups() {
    if (found == null) {
      found = find();
    }
    return found;
  }

  private static ControlGroups find() {
    try {
      Hierarchies hierarchies = Hierarchies.ofThisProcess();
      GroupFiles files = new GroupFiles();
      GroupOwner owner = GroupOwner.thisProcess();
      Optional<ControlGroups> groups = VersionOne.find(files, hierarchies, owner);
      if (groups.isEmpty()) {
        groups = VersionTwo.find(files, hierarchies, owner);
      }
      if (groups.isEmpty()) {
        return new NoControlGroups("no control group is delegated to this user; " + ADVICE);
      }
      probe(groups.get());
      return groups.get();
    } catch (IOException e) {
      return new NoControlGroups("control groups do not work here (" + e + "); " + ADVICE);
    }
  }

  /** Checks that a process can enter a group and that the group can be removed. */
  private static void probe(ControlGroups groups) throws IOException {
    ControlGroup group = groups.create(PROBE);
    try {
      StringBuilder script = new StringBuilder("true");
      for (Path entrance : group.entrances()) {
        script.append(" && echo 0 >'").append(entrance).append("'");
      }
      Process process =
          new ProcessBuilder("/bin/sh", "-c", script.toString())
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!process.waitFor(PROBE_SECONDS, TimeUnit.SECONDS) || process.exitValue() != 0) {
        process.destroyForcibly();
        throw new IOException("no process can enter " + List.copyOf(group.entrances()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } finally {
      group.remove();
    }
  }
}
