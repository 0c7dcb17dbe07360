package org.sitaf.server.result;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.document.CsvCells;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.TestResult;

/**
 * Writes the result of sequences as CSV with a line per step. A column {@code STEP.INPUT} has the
 * values of an input.
 */
final class StepCsv {
  private StepCsv() {}

  static byte[] write(TestResult result) {
    Map<String, Integer> columns = new LinkedHashMap<>();
    for (CaseResult testCase : result.cases()) {
      for (StepResult step : testCase.steps()) {
        step.inputs().forEach(i -> columns.putIfAbsent(column(step, i), columns.size()));
      }
    }
    List<String> header = new ArrayList<>(List.of("no", "case verdict"));
    result.parameters().stream().map(CaseParameter::name).forEach(header::add);
    header.addAll(List.of("step", "name", "class"));
    header.addAll(columns.keySet());
    header.addAll(
        List.of(
            "expected",
            "actual",
            "verdict",
            "after_failure",
            "at_s",
            "time_us",
            "before",
            "after",
            "message",
            "case message"));
    StringBuilder csv = new StringBuilder(CsvCells.line(header));
    for (CaseResult testCase : result.cases()) {
      for (int i = 0; i < testCase.steps().size(); i++) {
        csv.append(CsvCells.line(line(testCase, i, columns)));
      }
    }
    return csv.toString().getBytes(StandardCharsets.UTF_8);
  }

  private static List<String> line(CaseResult testCase, int index, Map<String, Integer> columns) {
    StepResult step = testCase.steps().get(index);
    List<String> line = new ArrayList<>();
    line.add(Integer.toString(testCase.no()));
    line.add(testCase.verdict().name());
    line.addAll(testCase.values());
    line.add(Integer.toString(index + 1));
    line.add(step.name());
    line.add(step.kind() == StepResult.Kind.VALID ? "valid" : step.kind().words());
    String[] inputs = new String[columns.size()];
    Arrays.fill(inputs, "");
    for (NamedValue input : step.inputs()) {
      inputs[Objects.requireNonNull(columns.get(column(step, input)))] = input.literal();
    }
    line.addAll(List.of(inputs));
    line.add(ResultCsv.values(step.expected()));
    line.add(ResultCsv.values(step.actual()));
    line.add(step.verdict().name());
    line.add(Boolean.toString(step.afterFailure()));
    line.add(step.at() == null ? "" : step.at().toString());
    line.add(step.time() == null ? "" : ResultCsv.number(step.time().total()));
    line.add(orEmpty(step.before()));
    line.add(orEmpty(step.after()));
    line.add(step.message());
    // A case can also fail before its first step, or by a condition over all steps.
    line.add(testCase.message());
    return line;
  }

  private static String column(StepResult step, NamedValue input) {
    return step.name() + "." + input.output();
  }

  private static String orEmpty(@Nullable String text) {
    return text == null ? "" : text;
  }
}
