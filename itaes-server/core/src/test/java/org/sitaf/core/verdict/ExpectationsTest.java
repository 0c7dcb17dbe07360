package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;

/** Verdict and message of recorded cases with expected values. */
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

  private static CaseResult judged(
      String outputs, List<ExpectedValue> expected, CaseRecord record) {
    TestModel model =
        TestModelXml.read(
            new ByteArrayInputStream(MODEL.formatted(outputs).getBytes(StandardCharsets.UTF_8)),
            "Half.xml");
    TestSuite suite =
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT)
            .suite()
            .withCases(List.of(new TestCase(1, true, List.of("2"), expected)));
    return new ResultAssembler(model, suite).judge(record);
  }

  private static CaseRecord returned(NamedValue... actual) {
    return new CaseRecord(
        1, CaseRecord.Outcome.RETURNED, "", List.of(actual), StubCalls.NONE, null, "");
  }

  private static CaseRecord threw(String type) {
    return new CaseRecord(
        1,
        CaseRecord.Outcome.THREW,
        type,
        List.of(),
        StubCalls.NONE,
        new CaseResult.ProcessingTime(1, 0, 0),
        type + ": too fast");
  }

  private static CaseResult judged(String expected, CaseRecord record) {
    return judged(
        output("return", "RETURN", "double"), List.of(new ExpectedValue("", expected)), record);
  }

  @Test
  void theResultHasTheValuesOfTheSuiteAndAnUnnamedOutput() {
    CaseResult result = judged("1.0", returned(new NamedValue("return", "-999.0")));

    assertThat(result)
        .isEqualTo(
            new CaseResult(
                1,
                Verdict.FAIL,
                List.of("2"),
                List.of(new NamedValue("", "1.0")),
                List.of(new NamedValue("", "-999.0")),
                null,
                "expected 1.0, but was -999.0"));
  }

  /** A record of a megabyte is the longest that an agent reads; each case can have one. */
  @Test
  @Timeout(20)
  void aRecordedNumberOfManyDigitsDiffersAtOnce() {
    String outputs = output("return", "RETURN", "int");
    CaseRecord record = returned(new NamedValue("return", "9".repeat(1_000_000)));
    for (int no = 0; no < 10; no++) {
      CaseResult result = judged(outputs, List.of(new ExpectedValue("", "1")), record);
      assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    }
  }

  @Test
  void anOutputWithoutARecordedValueIsAnError() {
    CaseResult result = judged("1.0", returned());

    assertThat(result.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.message())
        .isEqualTo("the test application recorded no value of the output 'return'");
  }

  @Test
  void theNameOfAnExpectedErrorMayBeQualified() {
    for (String name : List.of("std::out_of_range", "a.b.out_of_range", "out_of_range")) {
      assertThat(judged("!error:" + name, threw("out_of_range")).verdict())
          .as(name)
          .isEqualTo(Verdict.PASS);
    }
    for (String name : List.of("std::range", "out_of_range::other", "range")) {
      assertThat(judged("!error:" + name, threw("out_of_range")).verdict())
          .as(name)
          .isEqualTo(Verdict.ERROR);
    }
  }

  @Test
  void comparesAnExpectedErrorByItsName() {
    CaseResult matching = judged("!error:TooFast", threw("TooFast"));

    assertThat(matching.verdict()).isEqualTo(Verdict.PASS);
    assertThat(matching.message()).isEmpty();
    assertThat(matching.actual()).containsExactly(new NamedValue("", "!error:TooFast"));
    assertThat(matching.time()).isNotNull();
    CaseResult other = judged("!error:TooFast", threw("TooSlow"));
    assertThat(other.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(other.message()).isEqualTo("TooSlow: too fast");
    assertThat(other.time()).isNull();
  }

  @Test
  void aStringThatLooksLikeAnErrorIsNotAnError() {
    CaseRecord record = returned(new NamedValue("return", "!error:TooFast"));

    assertThat(judged("!error:TooFast", record).verdict()).isEqualTo(Verdict.FAIL);
  }

  @Test
  void anExpectedErrorReplacesTheValuesOfOtherOutputs() {
    String outputs = output("return", "RETURN", "double") + output("way", "OUT", "double");
    List<ExpectedValue> expected =
        List.of(new ExpectedValue("return", "!error:TooFast"), new ExpectedValue("way", "2.0"));

    CaseResult matching = judged(outputs, expected, threw("TooFast"));
    assertThat(matching.verdict()).isEqualTo(Verdict.PASS);
    assertThat(matching.actual()).containsExactly(new NamedValue("return", "!error:TooFast"));
    CaseRecord record = returned(new NamedValue("return", "1.0"), new NamedValue("way", "2.0"));
    CaseResult notThrown = judged(outputs, expected, record);
    assertThat(notThrown.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(notThrown.message())
        .isEqualTo("return: expected the error TooFast, but it returned 1.0");
  }

  @Test
  void comparesOutputsByName() {
    String outputs = output("return", "RETURN", "double") + output("way", "OUT", "double");
    List<ExpectedValue> expected =
        List.of(new ExpectedValue("return", "1.0"), new ExpectedValue("way", "2.0"));
    NamedValue one = new NamedValue("return", "1.0");

    assertThat(judged(outputs, expected, returned(one, new NamedValue("way", "2"))).verdict())
        .isEqualTo(Verdict.PASS);
    assertThat(judged(outputs, expected, returned(one, new NamedValue("way", "3.0"))).message())
        .isEqualTo("way: expected 2.0, but was 3.0");
    assertThat(judged(outputs, expected, returned(one)).verdict()).isEqualTo(Verdict.ERROR);
  }

  @Test
  void aMissingElementIsAWrongValue() {
    String outputs = output("return[3]", "RETURN", "double");
    CaseResult result =
        judged(
            outputs,
            List.of(new ExpectedValue("", "1.0")),
            returned(new NamedValue("return", "[]"), new NamedValue("return[3]", "null")));

    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message()).isEqualTo("expected 1.0, but there is no such element");
  }

  @ParameterizedTest
  @CsvSource({"ERROR, ERROR", "NOT_CALLED, DONT"})
  void aCaseThatDidNotReturnKeepsItsMessage(CaseRecord.Outcome outcome, Verdict verdict) {
    CaseResult result =
        judged(
            "1.0",
            new CaseRecord(
                1,
                outcome,
                "",
                List.of(new NamedValue("return", "1.0")),
                StubCalls.NONE,
                null,
                "no battery"));

    assertThat(result.verdict()).isEqualTo(verdict);
    assertThat(result.message()).isEqualTo("no battery");
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
    return new ValueComparison(type, Tolerance.EXACT)
        .mismatch(expected, actual)
        .map(found -> found.path() + ": " + found.text())
        .orElse("");
  }

  @Test
  void comparesTheExpectedMembersOfStructs() {
    String actual = "{name: \"a, {\\\"b\", x: 0.1, path: [1, 2]}";

    assertThat(difference(POSE, "{path: [1, 2.0]}", actual)).isEmpty();
    assertThat(difference(POSE, "{x: 0.10000000149011612}", actual)).isEmpty();
    assertThat(difference(POSE, "{name: \"a, {\\\"b\"}", actual)).isEmpty();
    assertThat(difference(POSE, "{path: [1, 3]}", actual))
        .isEqualTo(".path[1]: expected 3, but was 2");
    assertThat(difference(POSE, "{path: [1]}", actual))
        .isEqualTo(".path: expected 1 elements, but there are 2");
    assertThat(difference(POSE, "{z: 1}", actual)).contains("Pose has no member z");
    assertThat(difference(POSE, "{x: 1}", "null")).contains("but was null");
    assertThat(difference(POSE, "x", actual)).contains("cannot be compared");
  }

  @Test
  void comparesLiteralsOfUnknownTypeByTheirForm() {
    DataType unknown = new DataType.Unknown("");

    assertThat(difference(unknown, "[1, {a: 2.0}]", "[1.0, {a: 2, b: 3}]")).isEmpty();
    assertThat(difference(unknown, "[1, {a: 2.0}]", "[1.0, {a: 3}]")).contains("[1].a");
    assertThat(difference(unknown, "LEFT", "RIGHT")).isNotEmpty();
  }

  @Test
  void comparesAnyLiteralQuickly() {
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
