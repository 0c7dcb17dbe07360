package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.ToIntFunction;

/**
 * Which lines of the component's sources a build reached.
 *
 * @param files in the order of their paths; only those that hold statements
 */
public record Coverage(List<File> files) {
  public Coverage {
    files = List.copyOf(files);
  }

  /**
   * A source of the component.
   *
   * @param path within the activity, '/' separators
   * @param lines that hold statements, ascending
   */
  public record File(String path, List<Line> lines) {
    public File {
      Objects.requireNonNull(path);
      lines = List.copyOf(lines);
    }
  }

  /**
   * A line that holds statements.
   *
   * @param number from 1
   * @param reached whether any of its statements ran
   * @param branches branches from it; 0 where there is only one
   * @param taken how many of them were taken
   */
  public record Line(int number, boolean reached, int branches, int taken) {
    public Line {
      if (number < 1 || branches < 0 || taken < 0 || taken > branches) {
        throw new IllegalArgumentException(
            "line " + number + ": " + taken + " of " + branches + " branches");
      }
    }
  }

  /** Per cent of the lines with statements that were reached; empty where there are none. */
  public OptionalDouble statement() {
    return percent(line -> line.reached() ? 1 : 0, line -> 1);
  }

  /** Per cent of the branches that were taken; empty where there are none. */
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
