package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Verdict;

/** The steps of a sequence as a table; the step that decides the verdict is marked. */
final class StepTable {
  private static final List<String> HEADER =
      List.of("", "Step", "PF", "Call", "ER", "MR", "At(s)", "State before");

  private StepTable() {}

  /** Prints one row for each step; nothing if the case is one call. */
  static void print(CaseResult result, String indent, PrintWriter out) {
    if (result.steps().isEmpty()) {
      return;
    }
    List<List<String>> rows = new ArrayList<>(List.of(HEADER));
    for (int i = 0; i < result.steps().size(); i++) {
      rows.add(row(i + 1, result.steps().get(i)));
    }
    int[] widths = new int[HEADER.size()];
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    out.println(indent + "steps of case " + result.no() + ":");
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder(indent);
      for (int i = 0; i < widths.length; i++) {
        line.append(row.get(i)).append(" ".repeat(widths[i] - row.get(i).length())).append("  ");
      }
      out.println(line.toString().stripTrailing());
    }
  }

  private static List<String> row(int number, StepResult step) {
    String kind = step.kind() == StepResult.Kind.VALID ? "" : " (" + step.kind().words() + ")";
    String after = step.afterFailure() && step.verdict() != Verdict.PASS ? " (after)" : "";
    return List.of(
        step.decides() ? ">" : "",
        Integer.toString(number),
        step.verdict().name() + after,
        CaseTable.cell(step.call()) + kind,
        values(step.expected()),
        values(step.actual()),
        step.at() == null ? "-" : step.at().toString(),
        step.before() == null ? "-" : CaseTable.cell(step.before()));
  }

  private static String values(List<NamedValue> values) {
    return values.isEmpty()
        ? "-"
        : CaseTable.cell(
            values.stream()
                .map(v -> v.output().isEmpty() ? v.literal() : v.output() + "=" + v.literal())
                .collect(Collectors.joining(" ")));
  }
}
