package org.sitaf.server.result;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sitaf.core.document.CsvCells;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;

/** A result as comma-separated values, a line a case, as RFC 4180 has it. */
final class ResultCsv {
  private ResultCsv() {}

  static byte[] write(TestResult result) {
    StringBuilder csv = new StringBuilder();
    List<String> header = new ArrayList<>(List.of("no"));
    result.parameters().stream().map(CaseParameter::name).forEach(header::add);
    header.addAll(
        List.of("expected", "actual", "verdict", "time_us", "hardware_us", "stub_us", "message"));
    csv.append(CsvCells.line(header));
    for (CaseResult kase : result.cases()) {
      List<String> fields = new ArrayList<>(List.of(Integer.toString(kase.no())));
      fields.addAll(kase.values());
      fields.add(values(kase.expected()));
      fields.add(values(kase.actual()));
      fields.add(kase.verdict().name());
      CaseResult.ProcessingTime time = kase.time();
      fields.add(time == null ? "" : number(time.total()));
      fields.add(time == null ? "" : number(time.hardware()));
      fields.add(time == null ? "" : number(time.stub()));
      fields.add(kase.message());
      csv.append(CsvCells.line(fields));
    }
    return csv.toString().getBytes(StandardCharsets.UTF_8);
  }

  /** A single value as it is, several by the names of their outputs. */
  static String values(List<NamedValue> values) {
    return values.stream()
        .map(v -> v.output().isEmpty() ? v.literal() : v.output() + "=" + v.literal())
        .collect(Collectors.joining("; "));
  }

  private static String number(double microseconds) {
    return String.format(Locale.ROOT, "%.3f", microseconds);
  }
}
