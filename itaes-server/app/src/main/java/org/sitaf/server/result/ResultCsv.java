package org.sitaf.server.result;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.document.CsvCells;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;

/** Writes a result as CSV (RFC 4180) with a line per case, or per step of a sequence. */
final class ResultCsv {
  private ResultCsv() {}

  static byte[] write(TestResult result) {
    if (result.cases().stream().anyMatch(c -> !c.steps().isEmpty())) {
      return StepCsv.write(result);
    }
    StringBuilder csv = new StringBuilder();
    List<String> header = new ArrayList<>(List.of("no"));
    result.parameters().stream().map(CaseParameter::name).forEach(header::add);
    header.addAll(
        List.of(
            "expected",
            "actual",
            "verdict",
            "time_us",
            "hardware_us",
            "stub_us",
            "calls",
            "median_us",
            "low_us",
            "high_us",
            "message"));
    csv.append(CsvCells.line(header));
    for (CaseResult testCase : result.cases()) {
      List<String> fields = new ArrayList<>(List.of(Integer.toString(testCase.no())));
      fields.addAll(testCase.values());
      fields.add(values(testCase.expected()));
      fields.add(values(testCase.actual()));
      fields.add(testCase.verdict().name());
      CaseResult.ProcessingTime time = testCase.time();
      fields.add(time == null ? "" : number(time.total()));
      fields.add(time == null ? "" : number(time.hardware()));
      fields.add(time == null ? "" : number(time.stub()));
      RepeatedCalls repeated = testCase.repeated();
      fields.add(repeated == null ? "" : Integer.toString(repeated.calls()));
      fields.add(repeated == null ? "" : number(repeated.median()));
      fields.add(repeated == null ? "" : number(repeated.low()));
      fields.add(repeated == null ? "" : number(repeated.high()));
      fields.add(testCase.message());
      csv.append(CsvCells.line(fields));
    }
    return csv.toString().getBytes(StandardCharsets.UTF_8);
  }

  /** A single value without a name, or several values with the names of their outputs. */
  static String values(List<NamedValue> values) {
    return values.stream()
        .map(v -> v.output().isEmpty() ? v.literal() : v.output() + "=" + v.literal())
        .collect(Collectors.joining("; "));
  }

  static String number(@Nullable Double microseconds) {
    return microseconds == null ? "" : String.format(Locale.ROOT, "%.3f", microseconds);
  }
}
