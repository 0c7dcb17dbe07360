package org.sitaf.core.model.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.tuple;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.TestModel;

class TestModelXmlTest {
  private static TestModel read(String xml) {
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "model.xml");
  }

  private static List<Diagnostic> problems(String xml) {
    return catchThrowableOfType(InvalidInputException.class, () -> read(xml)).diagnostics();
  }

  private static String model(String elements) {
    return """
    <test_model>
      <name>M</name>
      <input_spec_list>
    %s
      </input_spec_list>
      <order_of_combinations>2</order_of_combinations>
    </test_model>
    """
        .formatted(elements);
  }

  @Test
  void reportsAllContradictionsWithElementAndLine() {
    List<Diagnostic> problems =
        problems(
            """
            <test_model>
              <name>M</name>
              <input_spec_list>
                <test_element abstract_type="NUMERIC" real_type="int">
                  <name>A</name><type>TDI</type>
                  <test_spec type="BVA" offset="0">
                    <equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="7" max="1"/>
                  </test_spec>
                </test_element>
                <test_element abstract_type="STRING" real_type="int">
                  <name>B</name><type>XXX</type>
                  <user_value_list><value>seven</value></user_value_list>
                </test_element>
                <test_element abstract_type="NUMERIC" real_type="uint8">
                  <name>A</name><type>TDI</type>
                </test_element>
              </input_spec_list>
              <invalid_values>ignore</invalid_values>
              <order_of_combinations>9</order_of_combinations>
            </test_model>
            """);
    assertThat(problems)
        .extracting(Diagnostic::element)
        .containsExactlyInAnyOrder(
            "test_element A/test_spec/equiv_class",
            "test_element A/test_spec/offset",
            "test_element B/type",
            "test_element B",
            "test_element B/user_value_list",
            "test_element A",
            "test_element A",
            "invalid_values",
            "order_of_combinations");
    assertThat(problems)
        .filteredOn(d -> d.element().equals("test_element A/test_spec/offset"))
        .first()
        .satisfies(
            d -> {
              assertThat(d.line()).isEqualTo(6);
              assertThat(d.toString())
                  .isEqualTo(
                      "model.xml:6: error: test_element A/test_spec/offset: must be greater than 0,"
                          + " not 0");
            });
  }

  @Test
  void rejectsADocumentTypeDeclaration() {
    String hostile =
        "<!DOCTYPE test_model [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>"
            + "<test_model><name>&x;</name></test_model>";
    assertThatThrownBy(() -> read(hostile))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("document type declarations and entities are not allowed");
  }

  @Test
  void reportsTheLineOfASyntaxError() {
    List<Diagnostic> problems = problems("<test_model>\n<name>M</nam>\n</test_model>");
    assertThat(problems).hasSize(1);
    assertThat(problems.get(0).line()).isEqualTo(2);
    assertThat(problems.get(0).message()).startsWith("not well-formed XML");
  }

  @ParameterizedTest
  @ValueSource(strings = {"a < b", "a && b"})
  void saysHowToWriteOperatorsInXml(String expression) {
    assertThat(
            problems("<test_model><name>" + expression + "</name></test_model>").get(0).message())
        .endsWith("In an expression, write &lt; for < and &amp;&amp; for &&.");
  }

  @Test
  void reportsAnotherRootElement() {
    assertThat(problems("<suite/>").get(0).message())
        .isEqualTo("the root element must be <test_model>");
  }

  @Test
  void reportsAMisspeltElement() {
    String misspelt =
        model(
            """
            <test_element abstract_type="NUMERIC" real_type="int">
              <name>A</name><type>TDI</type>
              <user_values><value>1</value></user_values>
              <user_value_list><value>1</value></user_value_list>
            </test_element>
            """);
    assertThat(problems(misspelt)).extracting(Diagnostic::element).containsExactly("user_values");
  }

  @Test
  void reportsAllMisspeltElementsInEveryDocument() {
    String element =
        """
        <test_element abstract_type="NUMERIC" real_type="int">
          <name>A%d</name><type>TDI</type><naem>x</naem>
          <user_value_list><value>1</value></user_value_list>
        </test_element>
        """;
    StringBuilder elements = new StringBuilder();
    for (int i = 0; i < 25; i++) {
      elements.append(element.formatted(i));
    }
    for (int reading = 0; reading < 3; reading++) {
      assertThat(problems(model(elements.toString())))
          .extracting(Diagnostic::element)
          .hasSize(25)
          .containsOnly("naem");
    }
  }

  @Test
  void readsSettingsFromElementsOrAttributes() {
    String element =
        """
        <test_element abstract_type="NUMERIC" real_type="double">
          <name>A</name><type>TDI</type>
          <test_spec type="RANDOM">
            <count>3</count><min>0</min><max>1</max>
            <distribution>normal</distribution><mean>0.5</mean>
            <standard_deviation>0.1</standard_deviation>
          </test_spec>
        </test_element>
        """;
    String attribute =
        """
        <test_element abstract_type="NUMERIC" real_type="double">
          <name>A</name><type>TDI</type>
          <test_spec type="RANDOM" count="3" min="0" max="1"
              distribution="normal" mean="0.5" standard_deviation="0.1"/>
        </test_element>
        """;
    assertThat(read(model(element)).inputs().get(0).specs())
        .isEqualTo(read(model(attribute)).inputs().get(0).specs());
  }

  @Test
  void acceptsTheSpellingsOfThePaper() {
    TestModel model =
        read(
            model(
                """
                <test_element abstract_type="NUMERIC" real_type="int">
                  <type>TDS</type><name>A</name>
                  <test_spec type="ECP"><equiv_class type="NEC_NUMERIC_ONE_BOUDARY" max="10"/></test_spec>
                </test_element>
                """));
    assertThat(model.inputs().get(0).kind()).isEqualTo(InputKind.TDSD);
    assertThat(model.target().method()).isEqualTo("M");
    assertThat(model.invalidValues()).isEqualTo(InvalidValues.ISOLATE);
  }

  @Test
  void rejectsANumberThatWouldExhaustMemory() {
    assertThat(
            problems(
                    model(
                        """
                        <test_element abstract_type="NUMERIC" real_type="int">
                          <name>A</name><type>TDI</type>
                          <user_value_list><value>1e999999999</value></user_value_list>
                        </test_element>
                        """))
                .get(0)
                .message())
        .isEqualTo("'1e999999999' is not a whole number");
  }

  @Test
  void boundsOfAnIntegerMustBeIntegers() {
    assertThat(
            problems(
                model(
                    """
                    <test_element abstract_type="NUMERIC" real_type="int">
                      <name>A</name><type>TDI</type>
                      <test_spec type="BVA" offset="0.5">
                        <equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="0.5" max="3"/>
                      </test_spec>
                    </test_element>
                    """)))
        .extracting(Diagnostic::message)
        .containsExactlyInAnyOrder(
            "0.5 is not a whole number, but the real_type is int32",
            "0.5 is not a whole number, but the real_type is int32");
  }

  @Test
  void settingsOfBoundariesAreErrorsWhereThereAreNone() {
    assertThat(
            problems(
                model(
                    """
                    <test_element abstract_type="BOOLEAN" real_type="boolean">
                      <name>A</name><type>TDI</type>
                      <test_spec type="ECP" offset="1" representatives="2">
                        <equiv_class type="NEC_BOOLEAN"/>
                      </test_spec>
                    </test_element>
                    <test_element abstract_type="NUMERIC" real_type="double">
                      <name>B</name><type>TDI</type>
                      <test_spec type="BVA" offset="1" special="true"/>
                    </test_element>
                    """)))
        .extracting(Diagnostic::element, Diagnostic::message)
        .containsExactlyInAnyOrder(
            tuple("test_element A/test_spec/offset", "has no effect in NEC_BOOLEAN; remove it"),
            tuple(
                "test_element A/test_spec/representatives",
                "has no effect in NEC_BOOLEAN; remove it"),
            tuple(
                "test_element B/test_spec/offset",
                "has no effect in BVA without an equiv_class, which has no boundaries; remove"
                    + " it"));
  }

  @Test
  void unknownNamesAreErrorsWithTheirLineAndTheNearestName() {
    String xml =
        """
        <test_model>
          <name>M</name>
          <target interface="I" methd="m"/>
          <input_spec_list>
            <test_element abstract_type="NUMERIC" real_type="int">
              <name>X</name>
              <type>TDI</type>
              <test_spec type="BVA" offst="1" offset="1">
                <equiv_class type="NEC_NUMERIC_ONE_BOUNDARY" min="1" minimum_inclusive="true"/>
              </test_spec>
              <user_values/>
            </test_element>
          </input_spec_list>
          <order_of_combination>2</order_of_combination>
          <order_of_combinations>2</order_of_combinations>
        </test_model>
        """;
    assertThat(problems(xml).stream().map(p -> p.line() + ": " + p.message()))
        .anyMatch(m -> m.startsWith("3: unknown attribute 'methd'; did you mean 'method'?"))
        .anyMatch(m -> m.startsWith("8: unknown attribute 'offst'; did you mean 'offset'?"))
        .anyMatch(
            m ->
                m.startsWith(
                    "9: unknown attribute 'minimum_inclusive'; did you mean 'min_inclusive'?"))
        .anyMatch(
            m -> m.startsWith("11: unknown element 'user_values'; did you mean 'user_value_list'?"))
        .anyMatch(
            m ->
                m.startsWith(
                    "14: unknown element 'order_of_combination'; did you mean 'order_of_combinations'?"))
        .hasSize(5);
  }

  @Test
  void settingsWithoutEffectAreErrors() {
    String xml =
        model(
            """
            <test_element abstract_type="NUMERIC" real_type="int"><name>X</name><type>TDI</type>
              <test_spec type="RANDOM" count="3" min="1" max="2" mean="1" length="2"/>
              <test_spec type="ECP"><equiv_class type="NEC_NUMERIC_CONSTANT" value="1" max="2"/></test_spec>
            </test_element>
            """);
    assertThat(problems(xml).stream().map(Diagnostic::message).toList())
        .anyMatch(m -> m.startsWith("length has no effect in RANDOM"))
        .anyMatch(
            m ->
                m.startsWith(
                    "mean and standard_deviation have no effect in the distribution uniform"))
        .anyMatch(m -> m.startsWith("max has no effect in NEC_NUMERIC_CONSTANT"))
        .hasSize(3);
  }
}
