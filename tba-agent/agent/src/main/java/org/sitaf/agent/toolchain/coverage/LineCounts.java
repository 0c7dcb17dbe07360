package org.sitaf.agent.toolchain.coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sitaf.core.verdict.Coverage;

/**
 * Merges the coverage of several processes: a line or branch is covered if any of them executed it.
 */
final class LineCounts {
  private final Map<String, TreeMap<Integer, Line>> files = new TreeMap<>();

  private static final class Line {
    private boolean reached;
    private final Map<String, Boolean> branches = new TreeMap<>();
  }

  void line(String file, int number, boolean reached) {
    Line line = at(file, number);
    line.reached |= reached;
  }

  /** Adds a branch of a line that was added by {@link #line}. */
  void branch(String file, int number, String name, boolean taken) {
    at(file, number).branches.merge(name, taken, Boolean::logicalOr);
  }

  private Line at(String file, int number) {
    return files
        .computeIfAbsent(file, f -> new TreeMap<>())
        .computeIfAbsent(number, n -> new Line());
  }

  Coverage coverage() {
    List<Coverage.File> all = new ArrayList<>();
    files.forEach(
        (path, lines) -> {
          List<Coverage.Line> merged = new ArrayList<>();
          lines.forEach((number, line) -> merged.add(merge(number, line)));
          all.add(new Coverage.File(path, merged));
        });
    return new Coverage(all);
  }

  private static Coverage.Line merge(int number, Line line) {
    int branches = line.branches.size() > 1 ? line.branches.size() : 0;
    int taken = (int) line.branches.values().stream().filter(covered -> covered).count();
    return new Coverage.Line(number, line.reached, branches, branches == 0 ? 0 : taken);
  }
}
