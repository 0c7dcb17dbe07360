package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.document.TestModelXml;

class ConditionsTest {
  private static GeneratedSuite generate(String preCondition, String expected) {
    return generate(preCondition, expected, "");
  }

  private static GeneratedSuite generate(String preCondition, String expected, String rest) {
    String xml =
        """
        <test_model>
          <name>M</name>
          <pre_condition_spec_list><pre_condition><![CDATA[%s]]></pre_condition></pre_condition_spec_list>
          <input_spec_list>
            <test_element abstract_type="NUMERIC" real_type="int"><name>a</name><type>TDI</type>
              <user_value_list><value>0</value><value>1</value><value>2</value></user_value_list></test_element>
            <test_element abstract_type="NUMERIC" real_type="double"><name>pose.x</name><type>TDI</type>
              <user_value_list><value>0.5</value><value>1.5</value></user_value_list></test_element>
          </input_spec_list>
          <output_spec_list>
            <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
              <expected><![CDATA[%s]]></expected></test_element>
          </output_spec_list>
          <order_of_combinations>2</order_of_combinations>
          %s
        </test_model>
        """
            .formatted(preCondition, expected, rest);
    return TestCaseGenerator.generate(
        TestModelXml.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml"),
        GenerationOptions.DEFAULT);
  }

  @Test
  void generatesNoCaseThatViolatesAPreConditionAndReportsImpossibleCombinations() {
    GeneratedSuite generated = generate("a <= pose.x", "1.0");
    assertThat(generated.suite().cases())
        .extracting(TestCase::values)
        .containsExactlyInAnyOrder(List.of("0", "0.5"), List.of("0", "1.5"), List.of("1", "1.5"));
    assertThat(generated.notes())
        .extracting(Diagnostic::message)
        .anyMatch(m -> m.contains("excluded by the pre-conditions"));
  }

  @Test
  void comparesIntegersWithFloatingPointNumbers() {
    assertThat(generate("true", "a < pose.x ? 1.0 : 0.0").suite().cases())
        .allSatisfy(
            c -> {
              boolean less =
                  Integer.parseInt(c.values().get(0)) < Double.parseDouble(c.values().get(1));
              assertThat(c.expected().get(0).literal()).isEqualTo(less ? "1.0" : "0.0");
            });
  }

  @Test
  void anExpectedValueHasTheTypeOfItsOutput() {
    assertThat(generate("true", "a").suite().cases())
        .allMatch(c -> c.expected().get(0).literal().matches("[012]\\.0"));
  }

  @Test
  void marksAndReportsAnExpectedValueThatCannotBeEvaluated() {
    GeneratedSuite generated = generate("true", "1 / a");
    assertThat(generated.suite().cases())
        .filteredOn(c -> c.values().get(0).equals("0"))
        .isNotEmpty()
        .allMatch(c -> c.expected().get(0).literal().startsWith("!unevaluated: "));
    assertThat(generated.notes()).isNotEmpty();
  }

  @Test
  void reportsAnUnknownNameBeforeTheGeneration() {
    assertThatThrownBy(() -> generate("b > 1", "Distanz"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining(
            "pre_condition_spec_list: 'b > 1' is not a valid expression: unknown name" + " 'b'")
        .hasMessageContaining("test_element return/expected: 'Distanz' is not a valid expression");
  }

  @Test
  void conditionsThatAllowNothingAreAnError() {
    assertThatThrownBy(() -> generate("a > 5", "1.0"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("no case");
  }

  @Test
  void keepsCasesWithTheirNumbersAndAddsMissingCombinationsOnly() {
    GeneratedSuite generated =
        generate(
            "true",
            "1.0",
            "<case_list><case no=\"12\"><value>1</value><value>0.5</value></case></case_list>");
    assertThat(generated.suite().cases()).hasSize(6);
    assertThat(generated.suite().cases())
        .filteredOn(c -> c.no() == 12)
        .extracting(TestCase::values)
        .containsExactly(List.of("1", "0.5"));
    assertThat(generated.suite().cases().stream().mapToInt(TestCase::no))
        .containsExactlyInAnyOrder(12, 13, 14, 15, 16, 17);
  }
}
