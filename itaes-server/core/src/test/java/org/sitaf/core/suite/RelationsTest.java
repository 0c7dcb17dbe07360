package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

class RelationsTest {
  private static final String MODEL =
      """
      <test_model>
        <name>M</name>
        <pre_condition_spec_list><pre_condition>a != 3</pre_condition></pre_condition_spec_list>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int8"><name>a</name><type>TDI</type>
            <test_spec type="ECP"><equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="0" max="100"/></test_spec>
            <user_value_list><value>1</value><value>2</value><value>100</value></user_value_list></test_element>
          <test_element abstract_type="NUMERIC" real_type="double"><name>pose.x</name><type>TDI</type>
            <user_value_list><value>0.5</value></user_value_list></test_element>
          <test_element abstract_type="NUMERIC" real_type="double"><name>Distance</name><type>TDSD</type>
            <user_value_list><value>1.5</value></user_value_list></test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
            <expected>a &gt;= 0 ? a : 0</expected></test_element>
          <test_element abstract_type="NUMERIC" real_type="int"><name>count</name><type>OUT</type></test_element>
        </output_spec_list>
      %s
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static final int FIRST_LINE = MODEL.substring(0, MODEL.indexOf("%s")).split("\n").length;

  private static TestModel read(String relations) {
    String xml = MODEL.formatted(relations);
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
  }

  private static TestModel relation(String change, String holds) {
    return read(
        "<relation_list><relation name=\"r\"><change name=\"a\">%s</change><holds><![CDATA[%s]]></holds></relation></relation_list>"
            .formatted(change, holds));
  }

  private static SecondRun second(TestModel model, WorldDescription world) {
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    return SecondRuns.of(model, suite, world).get(0);
  }

  private static List<Diagnostic> problems(String relations) {
    return catchThrowableOfType(
            InvalidInputException.class,
            () -> TestCaseGenerator.generate(read(relations), GenerationOptions.DEFAULT))
        .diagnostics();
  }

  @Test
  void changesTheInputsOfEachValidCaseAndKeepsItsNumber() {
    TestModel model = relation("a + 1", "after.value >= before.value");
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    assertThat(suite.cases()).anyMatch(c -> !c.valid());
    SecondRun run = SecondRuns.of(model, suite, null).get(0);
    for (TestCase second : run.suite().cases()) {
      TestCase first =
          suite.cases().stream().filter(c -> c.no() == second.no()).findFirst().orElseThrow();
      assertThat(first.valid()).isTrue();
      int a = Integer.parseInt(first.values().get(0));
      assertThat(second.values())
          .containsExactly(Integer.toString(a + 1), first.values().get(1), first.values().get(2));
      assertThat(second.expected().get(0).literal()).isEqualTo((a + 1) + ".0");
    }
    assertThat(run.suite().cases().size() + run.left().size()).isEqualTo((int) suite.validCount());
  }

  @Test
  void skipsCasesThatBreakAPreConditionOrTheType() {
    SecondRun plusOne = second(relation("a + 1", "after.value > before.value"), null);
    assertThat(plusOne.left().values())
        .singleElement()
        .satisfies(
            reason -> {
              assertThat(reason.failed()).isFalse();
              assertThat(reason.message()).contains("pre-condition");
            });
    SecondRun doubled = second(relation("a * 100", "after.value > before.value"), null);
    assertThat(doubled.left().values())
        .extracting(SecondRun.Reason::message)
        .anyMatch(m -> m.contains("the changed value of a does not fit int8: 200"));
    SecondRun halves = second(relation("0.5 * a", "after.value < before.value"), null);
    assertThat(halves.left().values())
        .extracting(SecondRun.Reason::message)
        .anyMatch(m -> m.contains("does not fit int8: '0.5' is not a whole number"));
    assertThat(halves.suite().cases()).isNotEmpty();
  }

  @Test
  void reportsAChangeThatCannotBeEvaluated() {
    SecondRun run = second(relation("10 / (a - 1)", "after.value != before.value"), null);
    assertThat(run.left().values())
        .filteredOn(SecondRun.Reason::failed)
        .singleElement()
        .satisfies(reason -> assertThat(reason.message()).contains("cannot be evaluated"));
  }

  @Test
  void skipsAParameterOutsideTheRangeOfTheWorld() {
    TestModel model =
        read(
            "<relation_list><relation name=\"r\"><change name=\"Distance\">2 * Distance</change>"
                + "<holds>after.value == before.value</holds></relation></relation_list>");
    WorldDescription world =
        new WorldDescription(
            "w",
            List.of(new WorldDescription.WorldParameter("Distance", "m", 0, 2, 1)),
            List.of(),
            List.of());
    assertThat(second(model, null).suite().cases()).isNotEmpty();
    assertThat(second(model, world).suite().cases()).isEmpty();
    assertThat(second(model, world).left().values())
        .allMatch(r -> r.message().contains("3.0 is outside the range [0.0, 2.0]"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "1 | <change name=\"b\">1</change><holds>after.value == 1.0</holds> | 'b' is not an input; did you mean 'a'? Inputs: Distance, a, pose.x",
        "1 | <change name=\"a\">1</change><change name=\"a\">2</change><holds>after.value == 1.0</holds> | another change sets a",
        "1 | <change name=\"a\"></change><holds>after.value == 1.0</holds> | is empty",
        "1 | <holds>after.value == 1.0</holds> | needs a change",
        "1 | <change name=\"a\">1</change> | needs a condition",
        "2 | <change name=\"a\">1</change>\\n<holds>after.value</holds> | must be true or false, but its type is double",
        "2 | <change name=\"a\">1</change>\\n<holds>after.speed == 1.0</holds> | speed",
        "2 | <change name=\"a\">1</change>\\n<holds>actual == after.value</holds> | actual",
        "2 | <change name=\"a\">1</change>\\n<holds>before.value == 1.0</holds> | does not use 'after'",
        "3 | <change name=\"a\">1</change>\\n<holds>true</holds>\\n<holds>false</holds> | a relation has one holds",
        "1 | <change name=\"a\">\"one\"</change><holds>after.value == 1.0</holds> | is string, but that of the input is int8",
        "1 | <change name=\"a\">\"!error:X\"</change><holds>after.value == 1.0</holds> | is outcome, but that of the input is int8",
        "1 | <change name=\"a\">after.value</change><holds>after.value == 1.0</holds> | after",
        "1 | <change name=\"a\" from=\"b\">1</change><holds>after.value == 1.0</holds> | unknown attribute 'from'"
      })
  void reportsWithItsLine(int line, String content, String message) {
    String text = content.replace("\\n", "\n");
    assertThat(
            problems("<relation_list><relation name=\"r\">" + text + "</relation></relation_list>"))
        .anySatisfy(
            problem -> {
              assertThat(problem.message()).contains(message);
              assertThat(problem.line()).isEqualTo(FIRST_LINE + line);
            });
  }

  @Test
  void reportsNamesThatAreUsedTwiceOrMissing() {
    String relation =
        "<relation name=\"%s\"><change name=\"a\">1</change><holds>after.value == 1.0</holds></relation>";
    assertThat(
            problems(
                "<relation_list>\n"
                    + relation.formatted("r")
                    + "\n"
                    + relation.formatted("r")
                    + "\n"
                    + relation.formatted(" ")
                    + "</relation_list>"))
        .extracting(Diagnostic::line, Diagnostic::message)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple(FIRST_LINE + 3, "another relation has this name"),
            org.assertj.core.groups.Tuple.tuple(
                FIRST_LINE + 4, "needs a name of at most 100 characters"));
  }

  @Test
  void reportsTooManyRelations() {
    String relations =
        "<relation name=\"r\"><change name=\"a\">1</change><holds>after.count == 1</holds></relation>"
            .repeat(21);
    assertThat(problems("<relation_list>" + relations + "</relation_list>"))
        .extracting(Diagnostic::message)
        .contains("has 21 relations, but at most 20 are allowed");
  }

  @Test
  void warnsAboutARelationThatIsNeverChecked() {
    GeneratedSuite generated =
        TestCaseGenerator.generate(
            relation("a * 0 + 3", "after.value == 3.0"), GenerationOptions.DEFAULT);
    assertThat(generated.notes())
        .anySatisfy(
            note -> {
              assertThat(note.message()).contains("is checked in none of the valid cases");
              assertThat(note.line()).isEqualTo(FIRST_LINE + 1);
            });
  }

  @Test
  void needsAValidCase() {
    String xml =
        MODEL
            .formatted(
                "<relation_list><relation name=\"r\"><change name=\"a\">1</change><holds>after.count == 1</holds></relation></relation_list>")
            .replace("a != 3", "!valid");
    TestModel model =
        TestModelXml.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
    assertThat(
            catchThrowableOfType(
                    InvalidInputException.class,
                    () -> TestCaseGenerator.generate(model, GenerationOptions.DEFAULT))
                .diagnostics())
        .anyMatch(d -> d.message().contains("the suite has no valid case"));
  }

  @Test
  void namesTheOutputsOfARunUniquely() {
    String xml =
        MODEL
            .formatted(
                "<relation_list><relation name=\"r\"><change name=\"a\">1</change><holds>after.value == 1.0</holds></relation></relation_list>")
            .replace(">count<", ">value<");
    TestModel model =
        TestModelXml.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
    assertThat(TestCaseGenerator.verifyConditions(model))
        .anyMatch(d -> d.message().contains("has the name of the return value"));
  }
}
