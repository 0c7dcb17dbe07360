package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.RelationCount;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Prints a result like the paper (Fig. 17a): summary, then a row per case with ER (expected), MR
 * (measured) and PF (verdict).
 */
public final class ResultTable {
  private static final int MAX_NOTES = 20;

  private ResultTable() {}

  /** Prints one row per case, followed by the message of a case that did not pass. */
  public static void printCases(TestResult result, List<CaseResult> cases, PrintWriter out) {
    List<List<String>> rows = new ArrayList<>();
    List<String> header = new ArrayList<>(List.of("No"));
    result.parameters().stream().map(CaseParameter::name).forEach(header::add);
    header.addAll(List.of("ER", "MR", "PF", "Time(us)"));
    boolean repeated = result.cases().stream().anyMatch(c -> c.repeated() != null);
    if (repeated) {
      header.addAll(List.of("95 %", "First(us)"));
    }
    rows.add(header);
    for (CaseResult testCase : cases) {
      List<String> row = new ArrayList<>(List.of(Integer.toString(testCase.no())));
      row.addAll(testCase.values());
      row.add(values(testCase.expected()));
      row.add(values(testCase.actual()));
      row.add(testCase.verdict().name());
      String first = testCase.time() == null ? "-" : number(testCase.time().total());
      if (repeated) {
        row.add(testCase.micros().isPresent() ? number(testCase.micros().getAsDouble()) : "-");
        row.add(RepeatedCallsText.interval(testCase.repeated()));
      }
      row.add(first);
      rows.add(row.stream().map(CaseTable::cell).toList());
    }
    int columns = header.size();
    int[] widths = new int[columns];
    for (List<String> row : rows) {
      for (int i = 0; i < columns; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    for (int r = 0; r < rows.size(); r++) {
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < columns; i++) {
        line.append(" ".repeat(widths[i] - rows.get(r).get(i).length()));
        line.append(rows.get(r).get(i)).append("  ");
      }
      String reason = r == 0 ? "" : cases.get(r - 1).message();
      out.println((line + Printable.lines(reason, "    ")).stripTrailing());
    }
  }

  /** Prints all cases, verdict first. */
  public static void printAll(TestResult result, PrintWriter out) {
    CaseTable cases = new CaseTable(result);
    cases.printConstants(out);
    cases.print(result.cases(), "", out);
    out.println();
  }

  /**
   * Prints the cases that did not pass, grouped by verdict and message.
   *
   * @param maxRows maximum number of rows; 0 prints only the numbers of the cases
   */
  static void printFailures(TestResult result, int maxRows, PrintWriter out) {
    List<FailureGroup> groups = FailureGroup.of(result.cases());
    if (groups.isEmpty()) {
      return;
    }
    CaseTable cases = new CaseTable(result);
    if (maxRows > 0) {
      cases.printConstants(out);
    }
    int left = maxRows;
    for (FailureGroup group : groups) {
      left -= cases.print(group, left, out);
    }
    long failed = groups.stream().mapToLong(g -> g.cases().size()).sum();
    if (maxRows > 0 && failed > maxRows) {
      out.println("... and " + (failed - maxRows) + " more that did not pass; --table shows all");
    }
    out.println();
  }

  /** Prints the summary, and the reasons why a result is suspect. */
  public static void printSummary(TestResult result, PrintWriter out) {
    if (result.isSuspect()) {
      out.println(result.name() + ": SUSPECT, the verdicts cannot be trusted:");
      result.suspicions().forEach(reason -> out.println("  " + Printable.line(reason)));
    }
    Summary summary = result.summary();
    out.printf(
        Locale.ROOT,
        "%s: %d cases, %d PASS, %d FAIL, %d ERROR, %d DONT%s%s%s%n",
        result.name(),
        summary.total(),
        summary.pass(),
        summary.fail(),
        summary.error(),
        summary.dont(),
        summary.dont() == 0 ? "" : " (not executed)",
        summary.unjudged() == 0 ? "" : ", " + summary.unjudged() + " unjudged",
        summary.byError() == 0 ? "" : ", " + summary.byError() + " by an error");
    for (RelationCount relation : RelationCount.of(result.cases())) {
      out.printf(
          Locale.ROOT,
          "relation '%s': %d checked, %d broken, %d skipped, %d errors%n",
          Printable.line(relation.name()),
          relation.checked(),
          relation.broken(),
          relation.skipped(),
          relation.errors());
    }
    if (summary.times() != null) {
      out.printf(
          Locale.ROOT,
          "processing time of the component (us): min %s, max %s, average %s, standard deviation"
              + " %s%n",
          number(summary.times().min()),
          number(summary.times().max()),
          number(summary.times().average()),
          number(summary.times().standardDeviation()));
    }
    RepeatedCallsText.print(result, out);
    HardwareReport.of(result.cases())
        .ifPresent(report -> out.println("devices: " + Printable.line(report.text())));
    printNotes(result, out);
    Coverage coverage = result.coverage();
    if (coverage != null && coverage.statement().isPresent()) {
      out.printf(
          Locale.ROOT,
          "coverage of the component: %.1f %% of statements, %s%n",
          coverage.statement().getAsDouble(),
          coverage.branch().isPresent()
              ? String.format(Locale.ROOT, "%.1f %% of branches", coverage.branch().getAsDouble())
              : "no branches");
    }
    out.flush();
  }

  private static String values(List<NamedValue> values) {
    return values.isEmpty()
        ? "-"
        : values.stream()
            .map(v -> v.output().isEmpty() ? v.literal() : v.output() + "=" + v.literal())
            .collect(Collectors.joining(" "));
  }

  static String number(double microseconds) {
    return String.format(Locale.ROOT, "%.3f", microseconds);
  }

  /** Prints what the component did that no case looks at. */
  private static void printNotes(TestResult result, PrintWriter out) {
    List<CaseResult> executed =
        result.cases().stream().filter(c -> c.verdict() != Verdict.DONT).toList();
    List<String> notes =
        executed.stream()
            .flatMap(c -> c.notes().stream())
            .distinct()
            .filter(note -> executed.stream().allMatch(c -> c.notes().contains(note)))
            .sorted()
            .toList();
    notes.stream().limit(MAX_NOTES).forEach(note -> out.println("note: " + Printable.line(note)));
    if (notes.size() > MAX_NOTES) {
      out.println("note: " + (notes.size() - MAX_NOTES) + " more in the result file");
    }
  }
}
