package org.sitaf.cli.explain;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sitaf.cli.run.CaseTable;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.explain.report.CauseText;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** One plain sentence for each cause. */
final class ExplanationText {
  private static final int MAX_NUMBERS = 20;

  /** Sentences for a terminal. */
  static final CauseText SENTENCES = new CauseText(Printable::line, CaseTable::cell);

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
    for (List<Cause> causes : CauseText.merged(explanation.causes())) {
      Cause first = causes.get(0);
      out.println(model + ": " + SENTENCES.sentence(first));
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
                + SENTENCES.name(boundary.parameter())
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
