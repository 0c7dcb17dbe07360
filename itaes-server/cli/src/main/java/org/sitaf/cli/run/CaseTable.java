package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;

/**
 * The cases of a result as a table: verdict first, then the inputs, and one column for each output
 * with the expected (ER) and the measured (MR) value. Inputs that are the same in all cases are
 * printed once.
 */
public final class CaseTable {
  private static final int MAX_WIDTH = 40;

  /** In a suite of fewer cases, an input that does not vary is printed in each row. */
  private static final int MIN_CASES = 2;

  private final TestResult result;
  private final List<Column> columns = new ArrayList<>();
  private final List<String> constants = new ArrayList<>();

  private record Column(String name, Function<CaseResult, String> text) {}

  CaseTable(TestResult result) {
    this.result = result;
    columns.add(new Column("No", c -> Integer.toString(c.no())));
    columns.add(new Column("PF", c -> c.verdict().name()));
    boolean sequences = result.cases().stream().anyMatch(c -> !c.steps().isEmpty());
    if (sequences) {
      columns.add(new Column("Steps", CaseTable::steps));
    }
    for (int i = 0; i < result.parameters().size(); i++) {
      int at = i;
      String name = result.parameters().get(i).name();
      Set<String> values = new HashSet<>();
      result.cases().forEach(c -> values.add(c.values().get(at)));
      if (values.size() == 1 && result.cases().size() >= MIN_CASES) {
        constants.add(name + " = " + cell(values.iterator().next()));
      } else {
        columns.add(new Column(name, c -> c.values().get(at)));
      }
    }
    if (!sequences) {
      outputs("ER", CaseResult::expected);
      outputs("MR", CaseResult::actual);
    }
    boolean repeated = result.cases().stream().anyMatch(c -> c.repeated() != null);
    if (repeated) {
      columns.add(
          new Column(
              "Time(us)",
              c -> c.micros().isPresent() ? ResultTable.number(c.micros().getAsDouble()) : "-"));
      columns.add(new Column("95 %", c -> RepeatedCallsText.interval(c.repeated())));
    }
    columns.add(
        new Column(
            repeated ? "First(us)" : "Time(us)",
            c -> c.time() == null ? "-" : ResultTable.number(c.time().total())));
  }

  /** The names of the steps; the one that decides is marked. */
  private static String steps(CaseResult result) {
    return result.steps().stream()
        .map(s -> s.decides() ? "[" + s.name() + "]" : s.name())
        .collect(Collectors.joining(" "));
  }

  /** One column for each output that any case has. */
  private void outputs(String title, Function<CaseResult, List<NamedValue>> values) {
    Set<String> names = new LinkedHashSet<>();
    result.cases().forEach(c -> values.apply(c).forEach(v -> names.add(v.output())));
    if (names.isEmpty()) {
      columns.add(new Column(title, c -> "-"));
    }
    for (String name : names) {
      columns.add(
          new Column(
              names.size() == 1 ? title : (title + " " + name).strip(),
              c ->
                  values.apply(c).stream()
                      .filter(v -> v.output().equals(name))
                      .map(NamedValue::literal)
                      .findFirst()
                      .orElse("-")));
    }
  }

  /** Prints the inputs that are the same in all cases, if there are any. */
  void printConstants(PrintWriter out) {
    if (!constants.isEmpty()) {
      out.println("in all cases: " + String.join(", ", constants));
    }
  }

  /** Prints one row for each case. */
  void print(List<CaseResult> cases, String indent, PrintWriter out) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(columns.stream().map(column -> cell(column.name())).toList());
    cases.forEach(c -> rows.add(columns.stream().map(col -> cell(col.text().apply(c))).toList()));
    int[] widths = new int[columns.size()];
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder(indent);
      for (int i = 0; i < widths.length; i++) {
        line.append(" ".repeat(widths[i] - row.get(i).length())).append(row.get(i)).append("  ");
      }
      out.println(line.toString().stripTrailing());
    }
  }

  /**
   * Prints the verdict of a group, the message of its first case, and its cases.
   *
   * @param maxRows maximum number of rows; 0 prints the numbers of the cases instead
   * @return the number of printed rows
   */
  int print(FailureGroup group, int maxRows, PrintWriter out) {
    int count = group.cases().size();
    out.println(
        group.title(maxRows == 0)
            + (group.message().isEmpty() ? "" : ": " + Printable.lines(group.message(), "    ")));
    List<CaseResult> shown = group.cases().subList(0, Math.min(count, maxRows));
    if (!shown.isEmpty()) {
      print(shown, "  ", out);
      StepTable.print(group.cases().get(0), "    ", out);
    }
    return shown.size();
  }

  public static String cell(String text) {
    String line = Printable.line(text);
    return line.length() <= MAX_WIDTH ? line : line.substring(0, MAX_WIDTH - 1) + "…";
  }
}
