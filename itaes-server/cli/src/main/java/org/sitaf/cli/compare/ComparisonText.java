package org.sitaf.cli.compare;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceGroup;
import org.sitaf.core.compare.NotComparable;

/** Prints a comparison for people: each group with its first case as an example. */
final class ComparisonText {
  private static final int MAX_NUMBERS = 20;
  private static final int MAX_VALUE = 300;

  private final PrintWriter out;

  private ComparisonText(PrintWriter out) {
    this.out = out;
  }

  /**
   * Prints a comparison.
   *
   * @param otherTools packages and tools that the versions do not share
   */
  static void print(Comparison comparison, List<String> otherTools, PrintWriter out) {
    if (!otherTools.isEmpty()) {
      out.println("NEW does not use the same packages and tools:");
      otherTools.forEach(each -> out.println("  " + Printable.line(each)));
      out.println();
    }
    new ComparisonText(out).print(comparison);
  }

  private void print(Comparison comparison) {
    notComparable(comparison.notComparable());
    section(comparison.lastBits(), "differ in the last bits only, which does not count (--ulp)");
    section(comparison.slower(), "slower (medians in us)");
    section(
        comparison.unstable(),
        "unstable: runs of the same version disagree, so the difference does not count");
    for (DifferenceGroup group : comparison.groups()) {
      group(group);
    }
    long cases =
        comparison.differences().stream()
            .filter(d -> d.no() > 0)
            .map(d -> d.model() + " " + d.no())
            .distinct()
            .count();
    out.println(summary(comparison, cases));
    out.flush();
  }

  private static String summary(Comparison comparison, long differing) {
    int compared = comparison.cases().size();
    int differences = comparison.differences().size();
    if (compared == 0) {
      return "no case could be compared";
    }
    return "%s compared, %s"
        .formatted(
            count(compared, "case"),
            differences == 0
                ? "no differences"
                : count(differences, "difference") + " in " + count(differing, "case"));
  }

  private static String count(long number, String noun) {
    return number + " " + noun + (number == 1 ? "" : "s");
  }

  private void notComparable(List<NotComparable> entries) {
    if (entries.isEmpty()) {
      return;
    }
    out.println("not comparable:");
    Map<String, List<NotComparable>> byReason =
        entries.stream()
            .collect(
                Collectors.groupingBy(
                    n ->
                        n.model()
                            + (n.output().isEmpty() ? "" : ", " + n.output())
                            + ": "
                            + n.reason(),
                    LinkedHashMap::new,
                    Collectors.toList()));
    byReason.forEach(
        (text, same) -> {
          List<Integer> numbers =
              same.stream().map(NotComparable::no).filter(no -> no > 0).toList();
          out.println(
              "  "
                  + Printable.lines(text, "    ")
                  + (numbers.isEmpty() ? "" : " (" + numbers(numbers) + ")"));
        });
    out.println();
  }

  private void section(List<Difference> entries, String title) {
    if (entries.isEmpty()) {
      return;
    }
    out.println(title + ":");
    Map<String, List<Difference>> byOutput =
        entries.stream()
            .collect(
                Collectors.groupingBy(
                    d -> d.model() + (d.output().isEmpty() ? "" : ", " + d.output()),
                    LinkedHashMap::new,
                    Collectors.toList()));
    byOutput.forEach(
        (name, same) -> {
          Difference first = same.get(0);
          out.println(
              "  %s: %s; %s: BASE %s, NEW %s"
                  .formatted(
                      Printable.line(name),
                      numbers(same.stream().map(Difference::no).distinct().toList()),
                      "case " + first.no(),
                      shortened(first.base()),
                      shortened(first.now())));
        });
    out.println();
  }

  private void group(DifferenceGroup group) {
    Difference first = group.differences().get(0);
    out.println(Printable.line(group.text()));
    if (first.no() == 0) {
      out.println("  " + first.model());
    } else {
      out.println(
          "  "
              + first.model()
              + ", "
              + numbers(group.differences().stream().map(Difference::no).distinct().toList()));
      String inputs =
          first.inputs().entrySet().stream()
              .map(i -> i.getKey() + " = " + shortened(i.getValue()))
              .collect(Collectors.joining(", "));
      out.println(
          "  case %d%s%s"
              .formatted(
                  first.no(),
                  first.valid() ? "" : " (invalid inputs)",
                  inputs.isEmpty() ? "" : ": " + inputs));
    }
    if (first.step() != null) {
      out.println("    first " + shortened(first.step().toString()));
    }
    String what = first.output().isEmpty() ? "" : " " + Printable.line(first.output());
    String at = first.at() == null ? "" : " at " + first.at() + " s";
    out.println("    BASE%s%s: %s".formatted(what, at, shortened(first.base())));
    out.println("    NEW %s%s: %s".formatted(what, at, shortened(first.now())));
    out.println();
  }

  private static String numbers(List<Integer> numbers) {
    String some =
        numbers.stream().limit(MAX_NUMBERS).map(String::valueOf).collect(Collectors.joining(", "));
    return (numbers.size() == 1 ? "case " : "cases ")
        + some
        + (numbers.size() > MAX_NUMBERS ? " and " + (numbers.size() - MAX_NUMBERS) + " more" : "");
  }

  private static String shortened(String value) {
    String line = Printable.line(value);
    return line.length() <= MAX_VALUE ? line : line.substring(0, MAX_VALUE) + "…";
  }
}
