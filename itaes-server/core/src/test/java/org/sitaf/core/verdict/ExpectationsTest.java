package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.TestModelXml;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.document.TestResultXml;

/** A PASS that a test application reports stands only where what was measured says so, too. */
class ExpectationsTest {
  private static final String MODEL =
      """
      <test_model>
        <name>Half</name>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int"><name>n</name><type>TDI</type>
            <user_value_list><value>2</value></user_value_list>
          </test_element>
        </input_spec_list>
        <output_spec_list>%s</output_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static String output(String name, String kind, String type) {
    return """
        <test_element abstract_type="NUMERIC" real_type="%s"><name>%s</name><type>%s</type>
        </test_element>
        """
        .formatted(type, name, kind);
  }

  /** The verdict of one case that was reported as PASS. */
  private static CaseResult judged(String outputs, List<ExpectedValue> expected, String actual) {
    TestModel model =
        TestModelXml.read(
            new ByteArrayInputStream(MODEL.formatted(outputs).getBytes(StandardCharsets.UTF_8)),
            "Half.xml");
    TestSuite made = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    List<CaseParameter> parameters = made.parameters();
    TestSuite suite =
        new TestSuite(
            made.name(),
            "",
            made.modelName(),
            made.generation(),
            parameters,
            List.of(new TestCase(1, true, List.of("2"), expected)));
    return new ResultAssembler(model, suite)
        .judge(
            TestResultXml.readCase(
                "<test_result no=\"1\" verdict=\"PASS\"><value>2</value>"
                    + actual
                    + "</test_result>"));
  }

  private static CaseResult judged(String expected, String actual) {
    return judged(
        output("return", "RETURN", "double"),
        List.of(new ExpectedValue("", expected)),
        "<actual>" + actual + "</actual>");
  }

  @Test
  void aPassThatTheMeasuredValueContradictsIsAFailure() {
    CaseResult result = judged("1.0", "-999.0");

    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message())
        .isEqualTo("expected 1.0, but was -999.0, though the test application reported PASS");
  }

  @Test
  void aPassThatTheMeasuredValueConfirmsStands() {
    assertThat(judged("1", "1.0").verdict()).isEqualTo(Verdict.PASS);
    assertThat(judged("nan", "NaN").verdict()).isEqualTo(Verdict.PASS);
    assertThat(judged("inf", "Infinity").verdict()).isEqualTo(Verdict.PASS);
  }

  @Test
  void aPassWithoutAValueIsAnError() {
    CaseResult result =
        judged(output("return", "RETURN", "double"), List.of(new ExpectedValue("", "1.0")), "");

    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message()).contains("no value of it was recorded");
  }

  @Test
  void anExpectedErrorIsMetByItsNameAlone() {
    assertThat(judged("!error:TooFast", "!error:TooFast").verdict()).isEqualTo(Verdict.PASS);
    assertThat(judged("!error:TooFast", "1.0").verdict()).isEqualTo(Verdict.FAIL);
  }

  @Test
  void anExpectedErrorMeetsWhatIsExpectedOfTheOtherOutputs() {
    String outputs = output("return", "RETURN", "double") + output("way", "OUT", "double");
    List<ExpectedValue> expected =
        List.of(new ExpectedValue("return", "!error:TooFast"), new ExpectedValue("way", "2.0"));

    assertThat(judged(outputs, expected, "<actual>!error:TooFast</actual>").verdict())
        .isEqualTo(Verdict.PASS);
    assertThat(judged(outputs, expected, "<actual>2.0</actual>").verdict())
        .isEqualTo(Verdict.ERROR);
  }

  @Test
  void whatIsNotEvaluatedCannotPass() {
    CaseResult result = judged("!unevaluated: no such member", "1.0");

    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message()).contains("what is expected has no value: no such member");
  }

  @Test
  void everyOutputIsLookedAtByItsName() {
    String outputs = output("return", "RETURN", "double") + output("way", "OUT", "double");
    List<ExpectedValue> expected =
        List.of(new ExpectedValue("return", "1.0"), new ExpectedValue("way", "2.0"));

    assertThat(
            judged(
                    outputs,
                    expected,
                    "<actual name=\"return\">1.0</actual><actual name=\"way\">2</actual>")
                .verdict())
        .isEqualTo(Verdict.PASS);
    assertThat(
            judged(
                    outputs,
                    expected,
                    "<actual name=\"return\">1.0</actual><actual name=\"way\">3.0</actual>")
                .message())
        .startsWith("way: expected 2.0, but was 3.0");
    assertThat(judged(outputs, expected, "<actual name=\"return\">1.0</actual>").verdict())
        .isEqualTo(Verdict.ERROR);
  }

  @ParameterizedTest
  @CsvSource({
    "DOUBLE, 1.0, 1.05, 0.1, 0, 0, true",
    "DOUBLE, 1.0, 1.2, 0.1, 0, 0, false",
    "DOUBLE, 100, 101, 0, 0.01, 0, true",
    "DOUBLE, 0.1, 0.10000000149011612, 0, 0, 0, false",
    "FLOAT, 0.1, 0.10000000149011612, 0, 0, 0, true",
    "FLOAT, 0.1, 0.1, 0, 0, 0, true",
    "FLOAT, 1.0, 1.0000001, 0, 0, 0, false",
    "FLOAT, 1.0, 1.0000001, 0, 0, 1, true",
    "DOUBLE, 1.0, 1.0000000000000002, 0, 0, 1, true",
    "DOUBLE, 1.0, 1.0000000000000004, 0, 0, 1, false",
    "DOUBLE, Infinity, 1e300, 1e308, 0, 0, false",
    "DOUBLE, 1.0, NaN, 1e308, 0, 0, false",
    "DOUBLE, 1.0, one, 1, 0, 0, false",
    "INT64, 9223372036854775807, 9223372036854775806, 0, 0, 0, false",
    "INT64, 9223372036854775807, 9.223372036854775807e18, 0, 0, 0, true",
    "UINT64, 18446744073709551615, 18446744073709551615, 0, 0, 0, true",
    "INT32, 7, 8, 1, 0, 0, true",
    "INT32, 7, 7.0, 0, 0, 0, true",
    "INT32, 1, true, 0, 0, 0, true",
    "INT32, 1, false, 0, 0, 0, false",
    "INT32, 1, 1e999999999, 0, 0, 0, false",
    "INT32, 1, null, 0, 0, 0, false",
    "BOOLEAN, 1, true, 0, 0, 0, true",
    "BOOLEAN, true, false, 0, 0, 0, false",
    "BOOLEAN, true, 1, 0, 0, 0, false",
    "STRING, 1, 1.0, 0, 0, 0, false",
    "STRING, abc, abd, 9, 0, 0, false",
  })
  void scalarsCompareByTheirType(
      ScalarType type,
      String expected,
      String actual,
      double absolute,
      double relative,
      double ulp,
      boolean same) {
    RecordedValue value =
        new RecordedValue(new DataType.Scalar(type), new Tolerance(absolute, relative, ulp));
    assertThat(value.difference(expected, actual).isEmpty()).isEqualTo(same);
  }

  private static final DataType POSE =
      new DataType.Struct(
          "Pose",
          List.of(
              new DataType.Member("name", new DataType.Scalar(ScalarType.STRING)),
              new DataType.Member("x", new DataType.Scalar(ScalarType.FLOAT)),
              new DataType.Member(
                  "path", new DataType.Sequence(new DataType.Scalar(ScalarType.INT32)))));

  private static String difference(DataType type, String expected, String actual) {
    return new RecordedValue(type, Tolerance.EXACT).difference(expected, actual).orElse("");
  }

  @Test
  void structsCompareByTheMembersThatAreExpected() {
    String actual = "{name: \"a, {\\\"b\", x: 0.1, path: [1, 2]}";

    assertThat(difference(POSE, "{path: [1, 2.0]}", actual)).isEmpty();
    assertThat(difference(POSE, "{x: 0.10000000149011612}", actual)).isEmpty();
    assertThat(difference(POSE, "{name: \"a, {\\\"b\"}", actual)).isEmpty();
    assertThat(difference(POSE, "{path: [1, 3]}", actual))
        .isEqualTo(".path[1]: expected 3, but was 2");
    assertThat(difference(POSE, "{path: [1]}", actual))
        .isEqualTo(".path: expected 1 elements, but there are 2");
    assertThat(difference(POSE, "{z: 1}", actual)).contains("there is none");
    assertThat(difference(POSE, "{x: 1}", "null")).contains("but was null");
    assertThat(difference(POSE, "x", actual)).contains("cannot be compared");
  }

  @Test
  void whatIsOfNoKnownTypeComparesByItsSpelling() {
    DataType unknown = new DataType.Unknown("");

    assertThat(difference(unknown, "[1, {a: 2.0}]", "[1.0, {a: 2, b: 3}]")).isEmpty();
    assertThat(difference(unknown, "[1, {a: 2.0}]", "[1.0, {a: 3}]")).contains("[1].a");
    assertThat(difference(unknown, "LEFT", "RIGHT")).isNotEmpty();
  }

  @Test
  void noLiteralOfAComponentTakesLong() {
    DataType nested = new DataType.Unknown("");
    String deep = "[".repeat(500_000) + "]".repeat(500_000);
    char[] digits = new char[1 << 20];
    Arrays.fill(digits, '9');

    assertThat(difference(nested, "[[1]]", deep)).isNotEmpty();
    assertThat(difference(nested, deep, deep.replace("[]", "[1]"))).isNotEmpty();
    assertThat(difference(new DataType.Scalar(ScalarType.INT64), "1", new String(digits)))
        .isNotEmpty();
    assertThat(difference(new DataType.Scalar(ScalarType.DOUBLE), "1", new String(digits)))
        .hasSizeLessThan(400);
  }
}
