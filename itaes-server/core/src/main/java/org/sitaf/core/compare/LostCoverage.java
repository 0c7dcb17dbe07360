package org.sitaf.core.compare;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Coverage;

/**
 * The unchanged lines of the component that every run of the base version executes and no run of
 * the new version does.
 */
public final class LostCoverage {
  private final String model;
  private @Nullable Map<String, TreeSet<Integer>> lost;

  /** Begins without runs. */
  public LostCoverage(String model) {
    this.model = model;
  }

  /** Finds lines of the base version in the new one. */
  @FunctionalInterface
  public interface LineMap {
    /** The number of a line in the new version; 0 if it was changed or removed. */
    int inNew(String path, int line);
  }

  /** Adds one run of each version with all cases. */
  public void add(Coverage base, Coverage now, LineMap lines) {
    Map<String, TreeSet<Integer>> executed = lines(base, Coverage.Line::reached);
    Map<String, TreeSet<Integer>> missed = lines(now, line -> !line.reached());
    Map<String, TreeSet<Integer>> found = new TreeMap<>();
    executed.forEach(
        (path, numbers) -> {
          TreeSet<Integer> inNew = new TreeSet<>();
          numbers.forEach(number -> inNew.add(lines.inNew(path, number)));
          inNew.retainAll(missed.getOrDefault(path, new TreeSet<>()));
          if (lost != null) {
            inNew.retainAll(lost.getOrDefault(path, new TreeSet<>()));
          }
          if (!inNew.isEmpty()) {
            found.put(path, inNew);
          }
        });
    lost = found;
  }

  private static Map<String, TreeSet<Integer>> lines(
      Coverage coverage, Predicate<Coverage.Line> selected) {
    Map<String, TreeSet<Integer>> lines = new HashMap<>();
    for (Coverage.File file : coverage.files()) {
      TreeSet<Integer> numbers = new TreeSet<>();
      file.lines().stream().filter(selected).map(Coverage.Line::number).forEach(numbers::add);
      lines.put(file.path(), numbers);
    }
    return lines;
  }

  /** Whether no line is lost. */
  public boolean isEmpty() {
    return lost == null || lost.isEmpty();
  }

  /** One difference for each file, with the numbers of the lines in the new version. */
  public List<Difference> differences() {
    List<Difference> differences = new ArrayList<>();
    if (lost != null) {
      lost.forEach(
          (path, numbers) ->
              differences.add(
                  new Difference(
                      model,
                      0,
                      true,
                      DifferenceClass.COVERAGE_LOST,
                      path,
                      Map.of(),
                      "executes lines " + ranges(numbers),
                      "does not execute them",
                      null,
                      "",
                      Double.NaN)));
    }
    return differences;
  }

  private static String ranges(TreeSet<Integer> numbers) {
    StringBuilder text = new StringBuilder();
    int first = 0;
    for (int number : numbers) {
      if (!numbers.contains(number - 1)) {
        first = number;
      }
      if (!numbers.contains(number + 1)) {
        text.append(text.isEmpty() ? "" : ", ")
            .append(first == number ? "" : first + "-")
            .append(number);
      }
    }
    return text.toString();
  }
}
