package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;

/**
 * The comparison vectors of the compliance suite, whose verdicts and messages apply to all
 * languages.
 */
class ComparisonVectorsTest {
  private static final Path VECTORS = Path.of("../../tests/compliance/comparisons.tsv");
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final DataType POINT =
      new DataType.Struct(
          "Point", List.of(new DataType.Member("x", DOUBLE), new DataType.Member("y", DOUBLE)));

  static Stream<List<String>> vectors() throws IOException {
    return Files.readAllLines(VECTORS).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> List.of(line.split("\t", -1)));
  }

  private static TestModel modelOf(DataType type, Tolerance tolerance) {
    String document =
        """
        <test_model><name>Get</name>
          <input_spec_list/><output_spec_list/><order_of_combinations>1</order_of_combinations>
        </test_model>
        """;
    OutputElement output =
        new OutputElement("return", OutputKind.RETURN, "", type, "", null, tolerance, 0);
    return TestModelXml.read(
            new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)), "Get.xml")
        .withOutputs(List.of(output));
  }

  private static DataType type(String name) {
    if (name.startsWith("sequence<")) {
      return new DataType.Sequence(type(name.substring("sequence<".length(), name.length() - 1)));
    }
    return switch (name) {
      case "Point" -> POINT;
      case "Mode" -> new DataType.Enumeration("Mode", List.of("SLOW", "FAST"));
      default ->
          new DataType.Scalar(
              Stream.of(ScalarType.values())
                  .filter(scalar -> scalar.typeName().equals(name))
                  .findFirst()
                  .orElseThrow());
    };
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void verdictAndMessageEqualTheTable(List<String> row) {
    DataType type = type(row.get(0));
    Tolerance tolerance =
        new Tolerance(
            Double.parseDouble(row.get(1)),
            Double.parseDouble(row.get(2)),
            Double.parseDouble(row.get(3)));
    CaseResult result =
        new Expectations(modelOf(type, tolerance))
            .judge(
                new TestCase(1, true, List.of(), List.of(new ExpectedValue("", row.get(4)))),
                new CaseRecord(
                    1,
                    CaseRecord.Outcome.RETURNED,
                    "",
                    List.of(new NamedValue("return", row.get(5))),
                    StubCalls.NONE,
                    null,
                    ""));

    assertThat(result.verdict() + " " + result.message()).isEqualTo(row.get(6) + " " + row.get(7));
  }
}
