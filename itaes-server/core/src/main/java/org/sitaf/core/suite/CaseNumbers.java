package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Numbers and ranges of case numbers, such as {@code 9,12-20}.
 *
 * @param ranges in the order in which they are written
 */
public record CaseNumbers(List<Range> ranges) {
  private static final Pattern RANGE =
      Pattern.compile("\\s*(\\d{1,9})(?:\\s*-\\s*(\\d{1,9}))?\\s*");

  public CaseNumbers {
    ranges = List.copyOf(ranges);
  }

  /** A range of case numbers; both ends are included. */
  public record Range(int from, int to) {
    public Range {
      if (from < 1 || to < from) {
        throw new IllegalArgumentException(
            from < 1
                ? "case numbers start at 1, not " + from
                : "'" + from + "-" + to + "' ends before it starts");
      }
    }

    @Override
    public String toString() {
      return from == to ? Integer.toString(from) : from + "-" + to;
    }
  }

  /**
   * Parses a list of numbers and ranges.
   *
   * @throws IllegalArgumentException if it is not such a list
   */
  public static CaseNumbers parse(String text) {
    List<Range> ranges = new ArrayList<>();
    for (String part : text.split(",", -1)) {
      Matcher matcher = RANGE.matcher(part);
      if (!matcher.matches()) {
        throw new IllegalArgumentException(
            "expected case numbers such as 9,12-20, not '" + text + "'");
      }
      int from = Integer.parseInt(matcher.group(1));
      ranges.add(
          new Range(from, matcher.group(2) == null ? from : Integer.parseInt(matcher.group(2))));
    }
    return new CaseNumbers(ranges);
  }

  /** Exactly these numbers. */
  public static CaseNumbers of(Set<Integer> numbers) {
    return new CaseNumbers(numbers.stream().sorted().map(no -> new Range(no, no)).toList());
  }

  /** The same numbers in ascending ranges that neither overlap nor touch. */
  public CaseNumbers merged() {
    List<Range> sorted = new ArrayList<>();
    for (Range next : ranges.stream().sorted(Comparator.comparingInt(Range::from)).toList()) {
      Range last = sorted.isEmpty() ? null : sorted.get(sorted.size() - 1);
      if (last == null || next.from() > last.to() + 1) {
        sorted.add(next);
      } else {
        sorted.set(sorted.size() - 1, new Range(last.from(), Math.max(last.to(), next.to())));
      }
    }
    return new CaseNumbers(sorted);
  }

  /** The list as {@link #parse} reads it. */
  @Override
  public String toString() {
    return ranges.stream().map(Range::toString).collect(Collectors.joining(","));
  }

  /** The suite with only these cases, which keep their numbers. */
  public TestSuite select(TestSuite suite) {
    TreeMap<Integer, Integer> lastOfFirst = new TreeMap<>();
    merged().ranges().forEach(r -> lastOfFirst.put(r.from(), r.to()));
    return suite.withCases(
        suite.cases().stream()
            .filter(
                c -> {
                  Map.Entry<Integer, Integer> range = lastOfFirst.floorEntry(c.no());
                  return range != null && c.no() <= range.getValue();
                })
            .toList());
  }

  /**
   * The ranges whose first or last number does not exist in a suite. Numbers between may be
   * missing: dropped cases leave gaps.
   */
  public List<Range> missing(TestSuite suite) {
    Set<Integer> numbers = suite.cases().stream().map(TestCase::no).collect(Collectors.toSet());
    return ranges.stream()
        .filter(r -> !numbers.contains(r.from()) || !numbers.contains(r.to()))
        .toList();
  }
}
