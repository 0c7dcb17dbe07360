package org.sitaf.core.expression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.expression.function.Library;
import org.sitaf.core.model.Definition;

/** The functions, names and types of expressions. */
class ExpressionVectorsTest {
  private static final DataType REAL = TypeGrammar.parse("double").type();

  static final Scope SCOPE =
      Scope.of(
              Map.of(
                  "x", REAL,
                  "n", TypeGrammar.parse("int").type(),
                  "flag", TypeGrammar.parse("boolean").type(),
                  "text", TypeGrammar.parse("string").type(),
                  "path", TypeGrammar.parse("vector<double>").type(),
                  "pose", struct("Point", "x", "y", "z"),
                  "q", struct("Quaternion", "x", "y", "z", "w"),
                  "ir1.range", REAL,
                  "unknown", new DataType.Unknown("")))
          .with(
              List.of(
                  new Definition("more", "twice + 1", 2),
                  new Definition("twice", "2 * x", 1),
                  new Definition("chicken", "egg", 3),
                  new Definition("egg", "chicken + 1", 4)),
              Map.of("Mode.FAST", 3L, "FAST", 3L, "Color.RED", "RED", "x", 7L));

  static final Map<String, Object> VALUES =
      Map.of(
          "x",
          2.5,
          "n",
          3L,
          "flag",
          true,
          "text",
          "abc",
          "path",
          List.of(1.0, 2.0, 3.0),
          "pose",
          Map.of("x", 1.0, "y", 2.0, "z", 3.0),
          "q",
          Map.of("x", 0.0, "y", 0.0, "z", 1.0, "w", 1.0),
          "ir1.range",
          0.7,
          "unknown",
          1L);

  private final ExpressionCompiler compiler = new ExpressionCompiler(SCOPE);

  private static DataType struct(String name, String... members) {
    return new DataType.Struct(
        name, List.of(members).stream().map(m -> new DataType.Member(m, REAL)).toList());
  }

  static List<String> vectors() throws IOException {
    try (InputStream in = ExpressionVectorsTest.class.getResourceAsStream("vectors.txt")) {
      return new String(Objects.requireNonNull(in).readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.isBlank() && !line.startsWith("#"))
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void evaluates(String vector) throws EvaluationException {
    String[] parts = vector.split(" => ", 2);
    assertThat(shown(compiler.compile(parts[0]).evaluate(VALUES))).isEqualTo(parts[1]);
  }

  /** The examples of the documentation. */
  static List<String> documented() throws IOException {
    // The snippet "expressions-1-text".
    String text = Files.readString(Path.of("../../docs/expressions.md"));
    String begin = "```text title=\"Examples of functions\"\n";
    int from = text.indexOf(begin) + begin.length();
    return text.substring(from, text.indexOf("```", from)).lines().toList();
  }

  @ParameterizedTest
  @MethodSource("documented")
  void documentedExamplesHaveTheirValues(String example) throws EvaluationException {
    evaluates(example);
  }

  @Test
  void everyFunctionHasAnExample() throws IOException {
    List<String> examples = documented();
    for (String function : Library.names()) {
      assertThat(examples)
          .as(function)
          .anyMatch(e -> e.matches(".*\\b" + function + "\\(.* => .*"));
    }
  }

  private static String shown(Object value) {
    if (value instanceof List<?> list) {
      return list.stream()
          .map(ExpressionVectorsTest::shown)
          .collect(Collectors.joining(", ", "[", "]"));
    }
    if (value instanceof Map<?, ?> map) {
      Map<String, String> members = new LinkedHashMap<>();
      for (String name : List.of("x", "y", "z", "w")) {
        if (map.containsKey(name)) {
          members.put(name, shown(map.get(name)));
        }
      }
      return members.entrySet().stream()
          .map(m -> m.getKey() + ": " + m.getValue())
          .collect(Collectors.joining(", ", "{", "}"));
    }
    return value instanceof String text ? '"' + text + '"' : String.valueOf(value);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "posee.x | unknown name 'posee'; did you mean 'pose'?",
        "ir1.rang | unknown name 'ir1.rang'; did you mean 'ir1.range'?",
        "BLUE | unknown name 'BLUE'",
        "RED | the name 'RED' is not unique; write Color.RED",
        "pose.xx | 'pose' has no member 'xx'; did you mean 'x'?",
        "pose.x.y | is a double and has no members such as 'y'",
        "sqr(2) | unknown function 'sqr'; did you mean 'sqrt'?",
        "path.exist(p, p > 1) | unknown function 'exist'; did you mean 'exists'?",
        "sqrt(text) | sqrt needs a number, but 'text' is a string",
        "sqrt(1, 2) | sqrt takes sqrt(number)",
        "near(1, 2) | near takes near(value, value, number) or near(value, value, number, number)",
        "min(x) | min needs two or more numbers or one list of numbers, but 'x' is a double",
        "norm(q) | norm needs a list of numbers or a struct with x, y and z, but 'q' is a"
            + " Quaternion",
        "qnorm(pose) | qnorm needs a struct with x, y, z and w, but 'pose' is a Point",
        "min([x], x) | min needs numbers, but '[x]' is a list(double)",
        "near(x, text, 1) | near never holds for a double and a string",
        "near(path, x, 1) | near never holds for a list(double) and a double",
        "matches(x, text) | matches needs two strings, not a double and a string",
        "has(x.y) | 'x' is a double and has no members such as 'y'",
        "det(path) | det needs a list of rows, but 'path' is a list(double)",
        "x.sqrt() | call the function as sqrt(...)",
        "x + text | + does not add a double and a string",
        "x - flag | - needs two numbers, not a double and a bool",
        "x % 2 | % needs two whole numbers, not a double and an int",
        "x < text | < does not compare a double and a string",
        "text == 1 | never equal are a string and an int",
        "text in [1] | never contained is a string and a list(int)",
        "x && flag | && needs true or false, but 'x' is a double",
        "flag ? 1 : text | the branches of ?: have different types",
        "x ? 1 : 2 | ?: needs true or false, but 'x' is a double",
        "path[text] | an index of 'path' must be a number, not a string",
        "x[0] | 'x' is a double and has no elements",
        "x.all(i, i > 0) | 'x' is a double, but a macro needs a list or a map",
        "size(x) | 'x' is a double and has no size",
        "chicken + 1 | the definition 'chicken' is defined by itself: chicken → egg → chicken",
        "1 + | mismatched input",
        "x > 1 and flag | write && for 'and'",
        "x > 1 or flag | write || for 'or'",
        "x = 1 | write == to compare",
      })
  void findsBeforeTheEvaluation(String text, String problem) {
    assertThatThrownBy(() -> compiler.compile(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("'" + text + "' is not a valid expression: ")
        .hasMessageContaining(problem);
  }

  @Test
  void findsSeveralProblemsAtOnce() {
    assertThatThrownBy(() -> compiler.compile("wrong + sqr(other)"))
        .hasMessageContaining("'wrong'")
        .hasMessageContaining("'other'")
        .hasMessageContaining("'sqr'");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "1 / 2 * x | '1 / 2' divides two whole numbers, so its result is whole; write 1.0 / 2",
        "n / 2 <= x | write double(n) / 2",
        "sqrt(n / 2) | write double(n) / 2",
        "(flag ? n / 2 : x) > 0.5 | write double(n) / 2",
        "near(x, n / 2, 0.1) | write double(n) / 2",
      })
  void warnsAboutAWholeDivisionWhereADoubleIsExpected(String text, String warning) {
    assertThat(compiler.compile(text).wholeDivisions(false))
        .singleElement()
        .satisfies(w -> assertThat(w).contains(warning));
  }

  @Test
  void doesNotWarnWhereTheWholeResultIsUsedAsAWhole() {
    for (String text : List.of("n / 2", "n / 2 == 1", "4 / 2 * x", "path[n / 2] > 0.5", "x / 2")) {
      assertThat(compiler.compile(text).wholeDivisions(false)).as(text).isEmpty();
    }
    assertThat(compiler.compile("n / 2").wholeDivisions(true)).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "x <= 1.2 | 2.5 <= 1.2",
        "flag && x <= n - 1 | 2.5 <= 2",
        "!(x > 1) | 2.5 > 1",
        "!(x > 1 && flag) | 2.5 > 1",
        "near(x, 2.0, 0.1) | near(2.5, 2.0, 0.1)",
        "n in [1, 2] | 3 in [1, 2]",
        "flag ? x < 1 : true | 2.5 < 1",
        "text == 'x' | \"abc\" == \"x\"",
        "twice < 1 | 5.0 < 1",
        "path == [1] | [1.0, 2.0, 3.0] == [1]",
        "path.all(p, p <= 1.5) | 2.0 <= 1.5 for p = 2.0",
        "!path.exists(p, p > twice / 2.0) | 3.0 > 2.5 for p = 3.0",
        "path.all(p, [p, 9.0].all(q, q < x)) | 9.0 < 2.5 for q = 9.0 for p = 1.0",
        "path.all(p, is_nan(p)) | is_nan(1.0) for p = 1.0",
        "path.exists(p, p > 9.0) | ``",
        "cel.bind(d, x + 1.0, d < 1) | 3.5 < 1",
      })
  void explainsWhyAConditionIsFalse(String text, String compared) throws EvaluationException {
    Expression condition = compiler.compile(text);
    assertThat(condition.isTrue(VALUES)).isFalse();
    assertThat(condition.explain(VALUES)).isEqualTo(compared);
  }

  @Test
  void allOperandsOfADisjunctionDecide() {
    assertThat(compiler.compile("x < 1 || n > 5").explain(VALUES)).isEqualTo("2.5 < 1 and 3 > 5");
  }

  @Test
  void showsNothingWhereNothingIsCompared() {
    assertThat(compiler.compile("!flag").explain(VALUES)).isEmpty();
  }

  @Test
  void namesTheVariablesThatAreUsedDirectlyOrByDefinitions() {
    Expression expression = compiler.compile("more > 1 && path.all(n, n > 0) && ir1.range > FAST");
    assertThat(expression.variables()).containsExactlyInAnyOrder("x", "path", "ir1.range");
    assertThat(expression.definitions()).containsExactlyInAnyOrder("more", "twice");
  }

  @Test
  void evaluatesRowsAndBothSidesOfAComparison() throws EvaluationException {
    Expression atom = compiler.compile("2 * x <= ir1.range + n");
    Expression.Comparison comparison = atom.comparison().orElseThrow();
    assertThat(comparison.operator()).isEqualTo("<=");
    List<String> columns = List.of("ir1.range", "x");
    Map<String, Object> fixed = Map.of("n", 3L);
    double[] row = {0.5, 1.0};
    assertThat(comparison.left().overRows(columns, fixed).number(row)).isEqualTo(2.0);
    assertThat(comparison.right().overRows(columns, fixed).number(row)).isEqualTo(3.5);
    assertThat(atom.overRows(columns, fixed).isTrue(row)).isTrue();
    assertThat(compiler.compile("flag").comparison()).isEmpty();
  }
}
