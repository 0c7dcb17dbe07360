package org.sitaf.runtime.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The tables of tests/compliance that every runtime runs: literals, answers of stubs, texts. */
class ComplianceVectorsTest {
  private static final Path TABLES = Path.of("../../tests/compliance");
  private static final Pattern ESCAPE = Pattern.compile("\\\\u([0-9A-F]{4})");

  /** Like the generated enumerations of interfaces. */
  enum Mode {
    SLOW,
    FAST
  }

  /** Like the generated structs of interfaces. */
  public record Point(double x, double y) {
    /** All members zero. */
    public Point() {
      this(0, 0);
    }
  }

  private static final Map<String, Class<?>> TYPES =
      Map.ofEntries(
          Map.entry("int8", byte.class),
          Map.entry("int16", short.class),
          Map.entry("int32", int.class),
          Map.entry("int64", long.class),
          Map.entry("uint64", BigInteger.class),
          Map.entry("double", double.class),
          Map.entry("float", float.class),
          Map.entry("boolean", boolean.class),
          Map.entry("char", char.class),
          Map.entry("string", String.class),
          Map.entry("Mode", Mode.class),
          Map.entry("Point", Point.class));

  private static Stream<List<String>> rows(String table) throws IOException {
    return Files.readAllLines(TABLES.resolve(table)).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> List.of(line.split("\t", -1)));
  }

  static Stream<List<String>> literals() throws IOException {
    return rows("literals.tsv");
  }

  static Stream<List<String>> answers() throws IOException {
    return rows("answers.tsv");
  }

  static Stream<List<String>> texts() throws IOException {
    return rows("texts.tsv");
  }

  private static Class<?> type(String name) {
    return name.startsWith("sequence<")
        ? type(name.substring("sequence<".length(), name.length() - 1)).arrayType()
        : TYPES.get(name);
  }

  @ParameterizedTest
  @MethodSource("literals")
  void readsAndWritesLiterals(List<String> row) {
    String recorded = "";
    String message = "";
    try {
      recorded = Literals.of(Conversion.convert(row.get(1), type(row.get(0))));
    } catch (CaseDataException e) {
      message = String.valueOf(e.getMessage());
    }
    assertThat(List.of(recorded, message)).isEqualTo(row.subList(2, 4));
  }

  @ParameterizedTest
  @MethodSource("answers")
  void readsAnswers(List<String> row) {
    Class<?> type = type(row.get(0));
    try {
      Answer<Object> answer =
          Answer.read(row.get(1), zero(type), literal -> Conversion.convert(literal, type));
      assertThat(answer.delay().toNanos() / 1e9).isEqualTo(Double.parseDouble(row.get(2)));
      assertThat(answer.error() == null ? "-" : answer.error()).isEqualTo(row.get(3));
      assertThat(answer.error() == null ? Literals.of(answer.value()) : "-").isEqualTo(row.get(4));
      assertThat(row.get(5)).isEmpty();
    } catch (CaseDataException e) {
      assertThat(e).hasMessage(row.get(5));
    }
  }

  private static @Nullable Object zero(Class<?> type) {
    return type == double.class ? (Object) 0.0 : type == int.class ? (Object) 0 : null;
  }

  @ParameterizedTest
  @MethodSource("texts")
  void writesTextsToTheRecord(List<String> row) {
    String text =
        ESCAPE
            .matcher(row.get(0))
            .replaceAll(found -> Character.toString(Integer.parseInt(found.group(1), 16)));
    CaseResult result = new CaseResult(new TestCase(1, true, Map.of()));
    result.record("return", text);
    assertThat(result.line())
        .isEqualTo(
            "<case_record no=\"1\" outcome=\"RETURNED\"><actual name=\"return\">"
                + row.get(1)
                + "</actual></case_record>\n");
  }
}
