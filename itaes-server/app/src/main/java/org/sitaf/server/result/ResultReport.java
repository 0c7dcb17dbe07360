package org.sitaf.server.result;

import com.samskivert.mustache.Mustache;
import com.samskivert.mustache.Template;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.RelationCount;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * A result as one page to send: no script, nothing from elsewhere. The template escapes all texts.
 *
 * @param suspicions why the verdicts cannot be trusted; at most one text
 * @param leftOut which cases the page does not show; at most one text
 */
record ResultReport(
    String title,
    Provenance provenance,
    List<String> suspicions,
    List<Share> shares,
    List<Fact> facts,
    List<String> leftOut,
    List<String> parameters,
    List<Case> cases) {

  /** More rows than a browser shows comfortably; cases that failed come first. */
  private static final int MAX_CASES = 5000;

  private static final Template TEMPLATE = template();

  /** How many cases have a verdict. */
  record Share(Verdict verdict, int count) {}

  /** A number of the summary. */
  record Fact(String name, String value) {}

  /** A row of the table. */
  record Case(
      int no,
      Verdict verdict,
      List<String> values,
      String expected,
      String actual,
      String time,
      String message,
      List<StepTable> steps) {
    static Case of(CaseResult result) {
      OptionalDouble time = result.micros();
      return new Case(
          result.no(),
          result.verdict(),
          result.values(),
          ResultCsv.values(result.expected()),
          ResultCsv.values(result.actual()),
          time.isEmpty() ? "" : number(time.getAsDouble()),
          result.message(),
          StepTable.of(result));
    }
  }

  /**
   * The steps of a sequence, in a row below their case.
   *
   * @param columns number of columns of the table of cases
   */
  record StepTable(int columns, String open, String title, List<Step> rows) {
    /** The columns besides the parameters: number, verdict, outputs, time and message. */
    private static final int FIXED_COLUMNS = 6;

    /** Empty if the case is one call. */
    static List<StepTable> of(CaseResult result) {
      List<Step> rows = new ArrayList<>();
      for (int i = 0; i < result.steps().size(); i++) {
        rows.add(Step.of(i + 1, result.steps().get(i)));
      }
      return rows.isEmpty()
          ? List.of()
          : List.of(
              new StepTable(
                  FIXED_COLUMNS + result.values().size(),
                  result.verdict() == Verdict.PASS ? "" : "open",
                  result.steps().stream().map(StepResult::name).collect(Collectors.joining(" ")),
                  rows));
    }
  }

  /** A step; {@code decides} is a class of the row of the first one that did not pass. */
  record Step(
      int no,
      Verdict verdict,
      String decides,
      String call,
      String remark,
      String expected,
      String actual,
      String at,
      String time,
      String state,
      String message) {
    static Step of(int no, StepResult step) {
      List<String> remarks = new ArrayList<>();
      if (step.kind() != StepResult.Kind.VALID) {
        remarks.add(step.kind().words());
      }
      if (step.afterFailure() && step.verdict() != Verdict.PASS) {
        remarks.add("after a failure");
      }
      return new Step(
          no,
          step.verdict(),
          step.decides() ? "decides" : "",
          step.name()
              + step.inputs().stream()
                  .map(i -> i.output() + "=" + i.literal())
                  .collect(Collectors.joining(", ", "(", ")")),
          String.join(", ", remarks),
          ResultCsv.values(step.expected()),
          ResultCsv.values(step.actual()),
          step.at() == null ? "" : Double.toString(step.at()),
          step.time() == null ? "" : number(step.time().total()),
          step.before() == null ? "" : step.before(),
          step.message());
    }
  }

  static byte[] write(String activity, TestResult result) {
    return TEMPLATE.execute(of(activity, result)).getBytes(StandardCharsets.UTF_8);
  }

  private static ResultReport of(String activity, TestResult result) {
    List<CaseResult> shown = result.cases();
    List<String> leftOut = List.of();
    if (shown.size() > MAX_CASES) {
      leftOut =
          List.of(
              "%d of %d cases, those that did not pass first; the CSV has all."
                  .formatted(MAX_CASES, shown.size()));
      shown =
          shown.stream()
              .sorted(Comparator.comparing(c -> c.verdict() == Verdict.PASS))
              .limit(MAX_CASES)
              .toList();
    }
    Summary summary = result.summary();
    return new ResultReport(
        activity + " / " + result.name(),
        result.provenance(),
        result.isSuspect() ? List.of(String.join("; ", result.suspicions())) : List.of(),
        List.of(
            new Share(Verdict.PASS, summary.pass()),
            new Share(Verdict.FAIL, summary.fail()),
            new Share(Verdict.ERROR, summary.error()),
            new Share(Verdict.DONT, summary.dont())),
        facts(result),
        leftOut,
        result.parameters().stream().map(CaseParameter::name).toList(),
        shown.stream().map(Case::of).toList());
  }

  private static List<Fact> facts(TestResult result) {
    Summary summary = result.summary();
    List<Fact> facts = new ArrayList<>();
    facts.add(new Fact("Total", Integer.toString(summary.total())));
    facts.add(new Fact("Pass", Integer.toString(summary.pass())));
    facts.add(new Fact("Fail", Integer.toString(summary.fail())));
    facts.add(new Fact("Error", Integer.toString(summary.error())));
    facts.add(new Fact("Not executed", Integer.toString(summary.dont())));
    Summary.Times times = summary.times();
    if (times != null) {
      facts.add(new Fact("Min (µs)", number(times.min())));
      facts.add(new Fact("Max (µs)", number(times.max())));
      facts.add(new Fact("Average (µs)", number(times.average())));
      facts.add(new Fact("Std deviation (µs)", number(times.standardDeviation())));
      if (times.first() != null) {
        facts.add(new Fact("First call, not included (µs)", number(times.first())));
      }
    }
    for (RelationCount relation : RelationCount.of(result.cases())) {
      facts.add(
          new Fact(
              relation.name(),
              "%d checked, %d broken, %d skipped, %d errors"
                  .formatted(
                      relation.checked(),
                      relation.broken(),
                      relation.skipped(),
                      relation.errors())));
    }
    return facts;
  }

  private static String number(double number) {
    return String.format(Locale.ROOT, "%.3f", number);
  }

  private static Template template() {
    try (Reader reader =
        new InputStreamReader(
            Objects.requireNonNull(ResultReport.class.getResourceAsStream("report.html.mustache")),
            StandardCharsets.UTF_8)) {
      return Mustache.compiler().compile(reader);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
