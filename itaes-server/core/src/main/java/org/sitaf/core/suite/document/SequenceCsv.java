package org.sitaf.core.suite.document;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.document.CsvCells;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

/**
 * Writes the sequences of a suite as comma-separated values: a header {@code
 * no,class,INITIAL...,step,name,step class,STEP.PARAMETER...,expected...} and one line per step.
 */
final class SequenceCsv {
  private SequenceCsv() {}

  static void write(TestSuite suite, Writer writer) throws IOException {
    Map<String, Integer> columns = new LinkedHashMap<>();
    for (StepParameters step : suite.stepParameters()) {
      for (CaseParameter parameter : step.parameters()) {
        columns.put(step.name() + "." + parameter.name(), columns.size());
      }
    }
    List<String> outputs =
        suite.cases().stream()
            .flatMap(c -> c.steps().stream())
            .flatMap(s -> s.expected().stream())
            .map(ExpectedValue::output)
            .distinct()
            .toList();
    List<String> header = new ArrayList<>(List.of("no", "class"));
    suite.parameters().stream().map(CaseParameter::name).forEach(header::add);
    header.addAll(List.of("step", "name", "step class"));
    header.addAll(columns.keySet());
    outputs.forEach(o -> header.add(o.isEmpty() ? "expected" : "expected " + o));
    writer.write(CsvCells.line(header));
    for (TestCase testCase : suite.cases()) {
      for (int i = 0; i < testCase.steps().size(); i++) {
        writer.write(CsvCells.line(line(suite, testCase, i, columns, outputs)));
      }
    }
  }

  private static List<String> line(
      TestSuite suite,
      TestCase testCase,
      int index,
      Map<String, Integer> columns,
      List<String> outputs) {
    TestStep step = testCase.steps().get(index);
    List<String> line = new ArrayList<>();
    line.add(Integer.toString(testCase.no()));
    line.add(testCase.valid() ? "valid" : "invalid");
    line.addAll(testCase.values());
    line.add(Integer.toString(index + 1));
    line.add(step.name());
    line.add(step.valid() ? "valid" : "invalid");
    String[] values = new String[columns.size()];
    java.util.Arrays.fill(values, "");
    List<CaseParameter> parameters = suite.stepParameters(step.name());
    for (int p = 0; p < parameters.size(); p++) {
      Integer column = columns.get(step.name() + "." + parameters.get(p).name());
      if (column != null) {
        values[column] = step.values().get(p);
      }
    }
    line.addAll(List.of(values));
    for (String output : outputs) {
      line.add(
          step.expected().stream()
              .filter(e -> e.output().equals(output))
              .map(ExpectedValue::literal)
              .findFirst()
              .orElse(""));
    }
    return line;
  }
}
