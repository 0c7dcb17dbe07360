package org.sitaf.cli.explain;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.run.CaseTable;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** One plain sentence for each cause. */
final class ExplanationText {
  private static final int MAX_NUMBERS = 20;

  private ExplanationText() {}

  /**
   * Prints the causes of a model. Causes with the same boundary are one sentence.
   *
   * @param all whether all cases were to be explained, not only selected ones
   */
  static void print(String model, Explanation explanation, boolean all, PrintWriter out) {
    if (all && explanation.causes().isEmpty() && explanation.unexplained().isEmpty()) {
      out.println(model + ": no case failed");
    }
    for (List<Cause> causes : merged(explanation.causes())) {
      Cause first = causes.get(0);
      out.println(model + ": " + sentence(first));
      List<Integer> numbers =
          causes.stream().flatMap(c -> c.cases().stream()).distinct().sorted().toList();
      if (!numbers.isEmpty()) {
        out.println("  cases: " + numbers(numbers));
      }
      out.println("  " + first.verdict() + ": " + Printable.lines(first.message(), "    "));
      if (first.steps().isEmpty()) {
        out.println("  simplest case: " + named(first.simplest()));
      } else if (!first.simplest().isEmpty()) {
        out.println("  set before the first step: " + named(first.simplest()));
      }
      Boundary boundary = first.boundary();
      if (boundary != null) {
        out.println(
            "  boundary: "
                + name(boundary.parameter())
                + " passes with "
                + Printable.line(boundary.passes())
                + " and fails with "
                + Printable.line(boundary.fails()));
      }
    }
    if (!explanation.unexplained().isEmpty()) {
      out.println(
          model
              + ": not explained: "
              + numbers(explanation.unexplained())
              + "; the failure is not reproducible, or the budget is too small");
    }
    if (!explanation.causes().isEmpty() || explanation.executions() > 0) {
      out.println(model + ": " + explanation.executions() + " further cases were executed");
    }
    out.flush();
  }

  /**
   * Prints the selected cases that need no explanation.
   *
   * @param selected results of the selected cases
   */
  static void printNotFailed(String model, List<CaseResult> selected, PrintWriter out) {
    List<Integer> passed = numbers(selected, Verdict.PASS);
    List<Integer> notExecuted = numbers(selected, Verdict.DONT);
    if (!passed.isEmpty()) {
      out.println(
          model
              + ": "
              + (passed.size() == 1
                  ? "case " + passed.get(0) + " passes"
                  : "cases " + numbers(passed) + " pass")
              + "; there is nothing to explain");
    }
    if (!notExecuted.isEmpty()) {
      out.println(model + ": not executed: " + numbers(notExecuted));
    }
    out.flush();
  }

  private static List<Integer> numbers(List<CaseResult> results, Verdict verdict) {
    return results.stream()
        .filter(r -> r.verdict() == verdict)
        .map(CaseResult::no)
        .sorted()
        .toList();
  }

  private static List<List<Cause>> merged(List<Cause> causes) {
    Map<Object, List<Cause>> groups = new LinkedHashMap<>();
    for (Cause cause : causes) {
      Boundary boundary = cause.boundary();
      Object key = cause;
      if (boundary != null) {
        Map<String, String> others = new LinkedHashMap<>(cause.parameters());
        others.remove(boundary.parameter());
        key = List.of(others, boundary);
      }
      groups.computeIfAbsent(key, k -> new ArrayList<>()).add(cause);
    }
    return List.copyOf(groups.values());
  }

  /** The cause as a sentence, such as: fails where `order` is XYZ, whatever the rest. */
  static String sentence(Cause cause) {
    String verb = cause.verdict().name().equals("ERROR") ? "ends with an error" : "fails";
    String relation = cause.relation();
    if (relation != null) {
      return verb + " where " + Printable.line(relation) + ", whatever the rest";
    }
    if (!cause.steps().isEmpty()) {
      return verb
          + " at the end of: "
          + cause.steps().stream().map(CaseTable::cell).collect(Collectors.joining(", "));
    }
    if (cause.parameters().isEmpty()) {
      return verb + " in every case";
    }
    List<String> parts = new ArrayList<>();
    cause.parameters().forEach((name, value) -> parts.add(part(name, value, cause.boundary())));
    String joined =
        parts.size() == 1
            ? parts.get(0)
            : String.join(", ", parts.subList(0, parts.size() - 1))
                + " and "
                + parts.get(parts.size() - 1);
    return verb
        + " where "
        + joined
        + (cause.simplest().size() == cause.parameters().size() ? "" : ", whatever the rest");
  }

  private static String part(String name, String value, @Nullable Boundary boundary) {
    if (boundary == null || !boundary.parameter().equals(name)) {
      return name(name) + " is " + (value.isEmpty() ? "empty" : Printable.line(value));
    }
    double passes = Double.parseDouble(boundary.passes());
    double fails = Double.parseDouble(boundary.fails());
    return name(name) + (fails > passes ? " is above " : " is below ") + boundary.passes();
  }

  private static String name(String name) {
    return "`" + Printable.line(name) + "`";
  }

  /** A case as text. */
  static String named(Map<String, String> values) {
    return values.entrySet().stream()
        .map(e -> Printable.line(e.getKey()) + " = " + CaseTable.cell(e.getValue()))
        .collect(Collectors.joining(", "));
  }

  private static String numbers(List<Integer> numbers) {
    return numbers.stream()
            .limit(MAX_NUMBERS)
            .map(Objects::toString)
            .collect(Collectors.joining(", "))
        + (numbers.size() > MAX_NUMBERS ? " and " + (numbers.size() - MAX_NUMBERS) + " more" : "");
  }
}
