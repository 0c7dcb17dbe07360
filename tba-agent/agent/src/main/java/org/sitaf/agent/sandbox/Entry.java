package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/**
 * What a process does before it becomes bubblewrap, which Java cannot do for it: it enters its
 * control group, so that nothing of it was ever outside, opens the filter of system calls, and
 * offers itself first where the whole machine is out of memory.
 */
final class Entry {
  /** Of the filter; bubblewrap closes it. Not one that the process is given for another purpose. */
  static final int FILTER = 9;

  private static final String SCRIPT =
      """
      filter=$1; shift
      while [ "$1" != -- ]; do echo 0 >"$1" || exit 126; shift; done
      shift
      { echo 500 >/proc/self/oom_score_adj; } 2>/dev/null
      [ -z "$filter" ] || exec %d<"$filter"
      exec "$@"
      """
          .formatted(FILTER);

  private Entry() {}

  static List<String> before(ControlGroup group, @Nullable Path filter) {
    List<String> words =
        new ArrayList<>(
            List.of("/bin/sh", "-c", SCRIPT, "sitaf", filter == null ? "" : filter.toString()));
    group.entrances().forEach(entrance -> words.add(entrance.toString()));
    words.add("--");
    return words;
  }
}
