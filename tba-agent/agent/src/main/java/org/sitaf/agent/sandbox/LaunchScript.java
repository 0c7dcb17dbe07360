package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/**
 * Shell prefix of the bubblewrap command, for the steps that Java cannot do between fork and exec:
 * enter the control group, open the system call filter, and raise the score by which the kernel
 * picks processes when the machine is out of memory.
 */
final class LaunchScript {
  /**
   * Descriptor of the filter, closed by bubblewrap. Must differ from {@link Confinement#CHANNEL}.
   */
  static final int FILTER_DESCRIPTOR = 9;

  private static final String SCRIPT =
      """
      filter=$1; shift
      while [ "$1" != -- ]; do echo 0 >"$1" || exit 126; shift; done
      shift
      { echo 500 >/proc/self/oom_score_adj; } 2>/dev/null
      [ -z "$filter" ] || exec %d<"$filter"
      exec "$@"
      """
          .formatted(FILTER_DESCRIPTOR);

  private LaunchScript() {}

  static List<String> prefix(ControlGroup group, @Nullable Path filter) {
    List<String> words =
        new ArrayList<>(
            List.of("/bin/sh", "-c", SCRIPT, "sitaf", filter == null ? "" : filter.toString()));
    group.entrances().forEach(entrance -> words.add(entrance.toString()));
    words.add("--");
    return words;
  }
}
