package org.sitaf.core.suite.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

class SequenceSuiteXmlTest {
  private static final TestSuite SUITE =
      new TestSuite(
          "LifeCycle-3way",
          "",
          "LifeCycle",
          new Generation(new Strength(2), InvalidValues.ISOLATE, 1, "default", "test"),
          List.of(new CaseParameter("Distance", InputKind.TDSD, "double")),
          List.of(
              new StepParameters("Read", List.of(new CaseParameter("Index", InputKind.TDI, "int"))),
              new StepParameters("DropsOut", List.of())),
          List.of(
              new TestCase(
                  1,
                  true,
                  List.of("2.5"),
                  List.of(),
                  List.of(
                      new TestStep("Read", true, List.of("1"), List.of()),
                      new TestStep("DropsOut", true, List.of(), List.of()))),
              new TestCase(
                  3,
                  false,
                  List.of("2.5"),
                  List.of(),
                  List.of(
                      new TestStep(
                          "Read",
                          false,
                          List.of(" <"),
                          List.of(new ExpectedValue("", "!error:NotEnabled")))))));

  private static String write(TestSuite suite) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestSuiteXml.write(suite, out);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static TestSuite read(String xml) {
    return TestSuiteXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "s.xml");
  }

  @Test
  void stepsAreWrittenAndRead() {
    String xml = write(SUITE);

    assertThat(read(xml)).isEqualTo(SUITE);
    assertThat(xml)
        .contains("<step name=\"Read\" class=\"invalid\"><value> &lt;</value>")
        .contains("<step name=\"DropsOut\"/>");
  }

  @Test
  void aTestApplicationGetsNoExpectedValues() {
    assertThat(write(SUITE.withoutExpected())).doesNotContain("expected");
  }

  @Test
  void stepsMustFitTheirParameters() {
    String xml = write(SUITE);

    assertThatThrownBy(() -> read(xml.replace("<value>1</value>", "")))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("has 0 values for 1 parameters");
    assertThatThrownBy(
            () -> read(xml.replaceFirst("<step name=\"DropsOut\"/>(?=\\s*</step_param)", "")))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("is not described in step_param_info");
  }

  @Test
  void suitesOfSingleCallsAreWrittenAsBefore() {
    TestSuite single =
        new TestSuite(
            "S",
            "",
            "M",
            SUITE.generation(),
            SUITE.parameters(),
            List.of(new TestCase(1, true, List.of("1.0"), List.of())));

    assertThat(write(single)).doesNotContain("step");
  }
}
