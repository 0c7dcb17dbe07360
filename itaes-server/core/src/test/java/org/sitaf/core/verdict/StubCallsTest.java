package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.document.CaseRecordLine;
import org.sitaf.core.verdict.document.TestResultXml;

/** Post-conditions about calls of required interfaces and about elements of outputs. */
class StubCallsTest {
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final InterfaceDescription WHEELS =
      new InterfaceDescription(
          "Wheels",
          List.of(
              new Method(
                  "Drive",
                  VOID,
                  List.of(new Parameter("speed", DOUBLE, Direction.IN)),
                  CallType.BLOCKING,
                  1),
              new Method("Stop", VOID, List.of(), CallType.BLOCKING, 2)),
          "wheels.xml");

  private static CaseResult judge(String condition, String actual, String calls) {
    String document =
        """
        <test_model>
          <name>Step</name>
          <input_spec_list>
            <test_element abstract_type="NUMERIC" real_type="int"><name>n</name><type>TDI</type>
              <user_value_list><value>1</value></user_value_list>
            </test_element>
          </input_spec_list>
          <output_spec_list>
            <test_element abstract_type="STRUCT" real_type="Pose"><name>return</name><type>RETURN</type></test_element>
          </output_spec_list>
          <post_condition_spec_list><post_condition>%s</post_condition></post_condition_spec_list>
          <order_of_combinations>1</order_of_combinations>
        </test_model>
        """
            .formatted(condition.replace("&", "&amp;").replace("<", "&lt;"));
    TestModel model =
        TestModelXml.read(
            new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)), "Step.xml");
    var suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    return new ResultAssembler(model, suite, List.of(WHEELS))
        .judge(
            CaseRecordLine.read(
                "<case_record no=\"1\" outcome=\"RETURNED\"><actual name=\"return\">"
                    + actual.replace("\"", "&quot;")
                    + "</actual>"
                    + calls
                    + "</case_record>"));
  }

  private static String drive(Object speed) {
    return "<call method=\"Wheels.Drive\"><argument name=\"speed\">" + speed + "</argument></call>";
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      textBlock =
          """
          calls["Wheels.Drive"].size() == 2                            ; PASS
          calls["Wheels.Drive"][0].speed == 1 && n == 1                ; PASS
          calls["Wheels.Drive"].all(c, c.speed <= 0.5)                 ; FAIL
          calls["Wheels.Stop"].size() == 1                             ; PASS
          calls[""] == ["Wheels.Drive", "Wheels.Drive", "Wheels.Stop"] ; PASS
          calls["Wheels.Drive"][2].speed == 1                          ; ERROR
          calls["Wheels.Turn"].size() == 0                             ; ERROR
          actual.x == 1.5 && actual.path[1].y == 2.0                   ; PASS
          actual.name == "a, }b"                                       ; PASS
          """)
  void evaluatesConditionsOnCallsAndElementsOfOutputs(String condition, Verdict verdict) {
    String calls = drive("1.0") + drive("0.25") + "<call method=\"Wheels.Stop\"></call>";
    CaseResult judged =
        judge(condition, "{x: 1.5, path: [{y: 1.0}, {y: 2.0}], name: \"a, }b\"}", calls);
    assertThat(judged.verdict()).as(judged.message()).isEqualTo(verdict);
  }

  @Test
  void aMethodWithoutCallsIsAKey() {
    assertThat(judge("calls[\"Wheels.Stop\"].size() == 0", "{}", "").verdict())
        .isEqualTo(Verdict.PASS);
  }

  @Test
  void aConditionOnOmittedCallsIsAnError() {
    CaseResult judged =
        judge(
            "calls[\"Wheels.Drive\"].size() < 5",
            "{}",
            drive(1) + "<calls_left_out>9</calls_left_out>");
    assertThat(judged.verdict()).isEqualTo(Verdict.ERROR);
    assertThat(judged.message()).contains("of 10 calls only the first 1 were recorded");
  }

  @Property(tries = 50)
  void countsEveryRecordedCallOnce(
      @ForAll @Size(max = 30) List<@IntRange(min = -9, max = 9) Integer> speeds) {
    StringBuilder calls = new StringBuilder();
    speeds.forEach(s -> calls.append(drive(s)));
    long fast = speeds.stream().filter(s -> s > 3).count();
    String condition =
        "calls[\"Wheels.Drive\"].filter(c, c.speed > 3).size() == "
            + fast
            + " && calls[\"\"].size() == "
            + speeds.size();
    assertThat(judge(condition, "{}", calls.toString()).verdict()).isEqualTo(Verdict.PASS);
  }

  @Test
  void readsTheCallsOfAWrittenResultUnchanged() {
    CaseResult result = judge("true", "{}", drive(2) + "<calls_left_out>3</calls_left_out>");
    assertThat(result.calls())
        .isEqualTo(
            new StubCalls(
                List.of(new StubCalls.Call("Wheels.Drive", List.of(new NamedValue("speed", "2")))),
                3));
    var out = new java.io.ByteArrayOutputStream();
    TestResult whole =
        new TestResult(
            "Step",
            new Provenance("", 1, "", "", "", "", "", ""),
            Statistics.of(List.of(result), true),
            List.of(),
            List.of(result),
            null);
    TestResultXml.write(whole, out);
    assertThat(TestResultXml.read(new ByteArrayInputStream(out.toByteArray()), "r.xml"))
        .isEqualTo(whole);
  }
}
