package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.document.TestModelXml;

/** Special values with a case each, inputs that follow others, and bounded suites. */
class SpecialAndRelatedTest {
  private static String element(String name, String type, String... specs) {
    return """
        <test_element abstract_type="%s" real_type="%s"><name>%s</name><type>TDI</type>%s</test_element>
        """
        .formatted(
            type.equals("Quaternion") ? "STRUCT" : "NUMERIC", type, name, String.join("", specs));
  }

  private static GeneratedSuite generate(String elements, String rest) {
    return generate(elements, rest, "");
  }

  private static GeneratedSuite generate(String elements, String rest, String before) {
    String xml =
        "<test_model><name>M</name>"
            + before
            + "<input_spec_list>"
            + elements
            + "</input_spec_list><order_of_combinations>2</order_of_combinations>"
            + rest
            + "</test_model>";
    return TestCaseGenerator.generate(
        TestModelXml.read(
            new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "model.xml"),
        GenerationOptions.DEFAULT);
  }

  private static String problems(String elements, String rest) {
    return catchThrowableOfType(InvalidInputException.class, () -> generate(elements, rest))
        .diagnostics()
        .stream()
        .map(Diagnostic::toString)
        .collect(Collectors.joining("\n"));
  }

  private static String bva(String min, String max, String more) {
    return "<test_spec type=\"BVA\" offset=\"1\" "
        + more
        + "><equiv_class type=\"NEC_NUMERIC_TWO_BOUNDARY\" min=\""
        + min
        + "\" max=\""
        + max
        + "\"/></test_spec>";
  }

  private static String related(String to, String offsets) {
    return "<test_spec type=\"RELATED\" to=\"" + to + "\" offsets=\"" + offsets + "\"/>";
  }

  @Test
  void relatedValuesAreNumbersNextToTheOtherInput() {
    TestSuite suite =
        generate(
                element("A", "double", bva("1", "3", ""))
                    + element("B", "double", related("A", "0 1ulp -1ulp 1e-17 -1e-12 -10%")),
                "")
            .suite();
    Set<List<String>> rows =
        suite.cases().stream().map(TestCase::values).collect(Collectors.toSet());
    assertThat(rows).hasSize(suite.cases().size());
    assertThat(rows)
        .contains(
            List.of("2.0", "2.0"),
            List.of("2.0", Double.toString(Math.nextUp(2.0))),
            List.of("2.0", Double.toString(Math.nextDown(2.0))),
            List.of("2.0", Double.toString(2 - 1e-12)),
            List.of("2.0", "1.8"));
    assertThat(suite.cases().stream().filter(c -> !c.valid()).map(c -> c.values().get(0)))
        .as("an invalid value of the other input makes the case invalid, once")
        .containsOnly("0.0", "4.0");
    // Next to 0, 1e-17 is a number of its own; elsewhere it equals the offset 0.
    assertThat(suite.validCount()).isEqualTo(3 * 5);
  }

  @Test
  void offsetsThatTheTypeCannotHoldMakeNoRowAndAreReported() {
    GeneratedSuite generated =
        generate(
            element(
                    "A",
                    "uint8",
                    "<user_value_list><value>0</value><value>255</value></user_value_list>")
                + element("B", "uint8", related("A", "0 1 -1")),
            "");
    assertThat(generated.suite().cases().stream().map(TestCase::values))
        .containsExactlyInAnyOrder(
            List.of("0", "0"), List.of("0", "1"), List.of("255", "255"), List.of("255", "254"));
    assertThat(generated.notes().toString())
        .contains("A + 1 where A is 255")
        .contains("A - 1 where A is 0");
  }

  @Test
  void conditionsSeeTheResolvedNumber() {
    TestSuite suite =
        generate(
                element("A", "int", bva("0", "4", ""))
                    + element("B", "int", related("A", "0 1 -1")),
                "",
                "<pre_condition_spec_list><pre_condition>B &lt;= A</pre_condition>"
                    + "</pre_condition_spec_list>")
            .suite();
    assertThat(suite.cases())
        .isNotEmpty()
        .allMatch(c -> Integer.parseInt(c.values().get(1)) <= Integer.parseInt(c.values().get(0)));
  }

  @Test
  void cyclesAreNamed() {
    assertThat(
            problems(
                element("A", "int", related("B", "0")) + element("B", "int", related("A", "0")),
                ""))
        .contains("A -> B -> A");
    assertThat(problems(element("A", "int", related("C", "0")) + element("B", "int"), ""))
        .contains("to names 'C'");
  }

  @Test
  void aRelatedRotationIsTurnedAboutZ() {
    TestSuite suite =
        generate(
                element("A", "Quaternion", "<test_spec type=\"ROTATION\" count=\"2\"/>")
                    + element("B", "Quaternion", related("A", "0 1e-9")),
                "")
            .suite();
    assertThat(suite.cases().stream().map(c -> String.join(" ", c.values())))
        .containsExactlyInAnyOrder(
            "{x: 0.0, y: 0.0, z: 0.0, w: 1.0} {x: 0.0, y: 0.0, z: 0.0, w: 1.0}",
            "{x: 0.0, y: 0.0, z: 0.0, w: 1.0} {x: 0.0, y: 0.0, z: 5.0E-10, w: 1.0}",
            "{x: 1.0, y: 0.0, z: 0.0, w: 0.0} {x: 1.0, y: 0.0, z: 0.0, w: 0.0}",
            "{x: 1.0, y: 0.0, z: 0.0, w: 0.0} {x: 1.0, y: 5.0E-10, z: 0.0, w: 0.0}");
  }

  @Test
  void specialValuesCanHaveACaseEach() {
    String b = element("B", "double", bva("0", "10", ""));
    TestSuite without = generate(element("A", "double", bva("0", "10", "")) + b, "").suite();
    TestSuite each =
        generate(element("A", "double", bva("0", "10", "special=\"each\"")) + b, "").suite();
    List<TestCase> added =
        each.cases().stream()
            .filter(
                c ->
                    without.cases().stream()
                        .noneMatch(w -> w.values().get(0).equals(c.values().get(0))))
            .toList();
    // Three neighbors of the boundaries, since the fourth is the smallest number; nine others.
    assertThat(added).hasSize(12);
    assertThat(added.stream().map(c -> c.values().get(0))).doesNotHaveDuplicates();
    assertThat(each.cases()).hasSize(without.cases().size() + 12);
    assertThat(added.stream().filter(c -> c.values().get(0).equals("NaN")).findFirst())
        .hasValueSatisfying(c -> assertThat(c.valid()).isFalse());
  }

  @Test
  void specialValuesNeedNoBoundaries() {
    TestSuite suite =
        generate(element("A", "double", "<test_spec type=\"BVA\" special=\"each\"/>"), "").suite();
    assertThat(suite.cases()).hasSize(9);
    assertThat(suite.validCount()).isEqualTo(6);
  }

  @Test
  void severalSpecificationsAreAUnion() {
    TestSuite suite =
        generate(
                element(
                    "A",
                    "int",
                    bva("1", "7", ""),
                    "<test_spec type=\"ECP\"><equiv_class type=\"NEC_NUMERIC_ONE_BOUNDARY\""
                        + " max=\"6\"/></test_spec>"),
                "")
            .suite();
    assertThat(suite.cases().stream().filter(TestCase::valid).map(c -> c.values().get(0)))
        .containsExactlyInAnyOrder("1", "2", "4", "5", "6");
    assertThat(suite.cases().stream().filter(c -> !c.valid()).map(c -> c.values().get(0)))
        .containsExactlyInAnyOrder("0", "7", "8");
  }

  @Test
  void nanIsValidWithoutAClass() {
    TestSuite suite =
        generate(
                element(
                    "A",
                    "double",
                    "<test_spec type=\"RANDOM\" count=\"2\" min=\"0\" max=\"1\" special=\"true\"/>"),
                "")
            .suite();
    assertThat(suite.cases()).hasSize(11).allMatch(TestCase::valid);
  }

  @Test
  void settingsWithoutEffectAreErrors() {
    assertThat(
            problems(
                element(
                    "A",
                    "string",
                    "<test_spec type=\"RANDOM_STRING\" special=\"true\" min_length=\"1\""
                        + " max_length=\"2\" alphabet=\"true\"/>"),
                ""))
        .contains("special has no effect in RANDOM_STRING");
  }
}
