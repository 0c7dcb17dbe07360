package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.ToIntFunction;

/**
 * The lines of the component's sources that a build executed.
 *
 * @param files sorted by path; only files with statements
 */
public record Coverage(List<File> files) {
  public Coverage {
    files = List.copyOf(files);
  }

  /**
   * A source of the component.
   *
   * @param path within the activity, '/' separators
   * @param lines lines with statements, in ascending order
   */
  public record File(String path, List<Line> lines) {
    public File {
      Objects.requireNonNull(path);
      lines = List.copyOf(lines);
    }
  }

  /**
   * A line with statements.
   *
   * @param number from 1
   * @param reached whether any of its statements was executed
   * @param branches number of branches; 0 if the line does not branch
   * @param taken number of branches that were taken
   */
  public record Line(int number, boolean reached, int branches, int taken) {
    public Line {
      if (number < 1 || branches < 0 || taken < 0 || taken > branches) {
        throw new IllegalArgumentException(
            "line " + number + ": " + taken + " of " + branches + " branches");
      }
    }
  }

  /** Statement coverage in per cent of lines; empty if there are no statements. */
  public OptionalDouble statement() {
    return percent(line -> line.reached() ? 1 : 0, line -> 1);
  }

  /** Branch coverage in per cent; empty if there are no branches. */
  public OptionalDouble branch() {
    return percent(Line::taken, Line::branches);
  }

  private OptionalDouble percent(ToIntFunction<Line> part, ToIntFunction<Line> whole) {
    long parts = sum(part);
    long all = sum(whole);
    return all == 0 ? OptionalDouble.empty() : OptionalDouble.of(100.0 * parts / all);
  }

  private long sum(ToIntFunction<Line> count) {
    return files.stream().flatMap(file -> file.lines().stream()).mapToLong(count::applyAsInt).sum();
  }
}
