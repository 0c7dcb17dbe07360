package org.sitaf.core.suite.sequence;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

class SequenceGeneratorTest {
  private static final String MODEL =
      """
      <test_model>
        <name>LifeCycle</name>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>Distance</name><type>TDSD</type>
            <user_value_list><value>0.5</value><value>2.0</value></user_value_list></test_element>
        </input_spec_list>
        <sequence_spec length="5" order="2">
          <state name="enabled" type="boolean" initial="false"/>
          <call name="Enable"><update state="enabled">true</update></call>
          <call name="Disable"><update state="enabled">false</update></call>
          <call name="Read">
            <guard>enabled</guard>
            <forbidden>!error:NotEnabled</forbidden>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>Index</name><type>TDI</type>
                <test_spec type="BVA" offset="1"><equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="1" max="7"/></test_spec></test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>return</name><type>RETURN</type>
                <expected>valid ? 10 * step : "!error:Range"</expected></test_element>
            </output_spec_list>
          </call>
          <event name="Nears" set="Distance" to="0.1"/>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations>
      %s
      </test_model>
      """;

  private static TestModel read(String xml) {
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
  }

  private static GeneratedSuite generate(String xml) {
    return TestCaseGenerator.generate(read(xml), GenerationOptions.DEFAULT);
  }

  private static final TestSuite SUITE = generate(MODEL.formatted("")).suite();

  private static final String LISTS =
      """
      <test_model>
        <name>Queue</name>
        <input_spec_list/>
        <sequence_spec length="4" order="2">
          <state name="queue" type="string[]" initial="%s"/>
          <call name="Put">
            <guard>size(queue) &lt; 2</guard>
            <update state="queue">queue + [item]</update>
            <input_spec_list>
              <test_element abstract_type="STRING" real_type="string"><name>item</name><type>TDI</type>
                <user_value_list><value>a</value><value>b, c</value></user_value_list></test_element>
            </input_spec_list>
          </call>
          <call name="Take">
            <guard>size(queue) > 0</guard>
            <forbidden>!error:Empty</forbidden>
            <update state="queue">queue.filter(i, i != queue[0])</update>
            <output_spec_list>
              <test_element abstract_type="STRING" real_type="string"><name>return</name><type>RETURN</type>
                <expected>queue[0]</expected></test_element>
            </output_spec_list>
          </call>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  @Test
  void anAbstractStateMayBeAList() {
    List<TestCase> cases = generate(LISTS.formatted("[ &quot;x&quot;]")).suite().cases();
    assertThat(cases)
        .flatExtracting(TestCase::steps)
        .filteredOn(step -> step.name().equals("Take") && step.valid())
        .flatExtracting(TestStep::expected)
        .extracting(ExpectedValue::literal)
        .contains("x")
        .containsAnyOf("a", "b, c");
  }

  @Test
  void anInitialListThatIsNoneIsReportedAtItsLine() {
    InvalidInputException refused =
        catchThrowableOfType(InvalidInputException.class, () -> generate(LISTS.formatted("none")));
    assertThat(refused.diagnostics())
        .singleElement()
        .satisfies(
            problem -> {
              assertThat(problem.line()).isEqualTo(5);
              assertThat(problem.message()).startsWith("'none' is not a value of sequence<string>");
            });
  }

  @Tag("slow")
  @Test
  void aHundredRandomModelsAreCovered() {
    GenerationOptions fast = new GenerationOptions(null, null, 1, Effort.FAST);
    int checked = 0;
    for (long seed = 1; checked < 100; seed++) {
      RandomSequenceModel random = new RandomSequenceModel(seed);
      if (!random.isPossible()) {
        continue;
      }
      TestSuite suite = TestCaseGenerator.generate(read(random.xml()), fast).suite();
      assertThat(random.violation(suite)).as("seed " + seed + "\n" + random.xml()).isEmpty();
      checked++;
    }
  }

  @Test
  void modelsWithAStepThatNoStateAllowsAreRefused() {
    int refused = 0;
    for (long seed = 1; refused < 10; seed++) {
      RandomSequenceModel random = new RandomSequenceModel(seed);
      if (!random.isPossible()) {
        assertThatThrownBy(() -> generate(random.xml()))
            .as(random.xml())
            .isInstanceOf(InvalidInputException.class);
        refused++;
      }
    }
  }

  @Test
  void expectedValuesSeeTheNumberOfTheStep() {
    for (TestCase testCase : SUITE.cases()) {
      for (int i = 0; i < testCase.steps().size(); i++) {
        TestStep step = testCase.steps().get(i);
        if (step.name().equals("Read") && step.valid()) {
          assertThat(step.expected().get(0).literal()).isEqualTo(Integer.toString(10 * (i + 1)));
        }
      }
    }
  }

  @Test
  void everyInitialRowStartsACase() {
    assertThat(SUITE.cases().stream().filter(TestCase::valid).map(c -> c.values().get(0)))
        .contains("0.5", "2.0");
  }

  @Test
  void aForbiddenCallIsFollowedByAnAllowedStep() {
    List<TestCase> forbidden =
        SUITE.cases().stream()
            .filter(
                c ->
                    c.steps().stream()
                        .anyMatch(
                            s ->
                                !s.valid()
                                    && s.expected().get(0).literal().equals("!error:NotEnabled")))
            .toList();

    assertThat(forbidden).isNotEmpty();
    assertThat(forbidden)
        .allSatisfy(c -> assertThat(c.steps().get(c.steps().size() - 1).valid()).isTrue());
  }

  @Test
  void theSameSeedGivesTheSameSuite() {
    assertThat(generate(MODEL.formatted("")).suite()).isEqualTo(SUITE);
  }

  @Test
  void keptCasesKeepTheirNumbers() {
    String list =
        """
        <case_list><case no="7"><value>2.0</value><step name="Enable"/><step name="Read"><value>4</value></step></case>
          <case no="9"><value>2.0</value><step name="Read"><value>4</value></step><step name="Read"><value>4</value></step></case></case_list>
        """;
    GeneratedSuite generated = generate(MODEL.formatted(list));

    TestCase kept =
        generated.suite().cases().stream().filter(c -> c.no() == 7).findFirst().orElseThrow();
    assertThat(kept.steps()).extracting(TestStep::name).containsExactly("Enable", "Read");
    assertThat(kept.steps().get(1).expected().get(0).literal()).isEqualTo("20");
    assertThat(generated.suite().cases()).allMatch(c -> c.no() == 7 || c.no() > 9);
    assertThat(generated.notes()).anyMatch(d -> d.message().contains("two steps are forbidden"));
  }

  @Test
  void casesOfAnEarlierSuiteAreKept() {
    GenerationOptions again = new GenerationOptions(null, null, 1, Effort.DEFAULT, SUITE);

    assertThat(TestCaseGenerator.generate(read(MODEL.formatted("")), again).suite().cases())
        .isEqualTo(SUITE.cases());
  }

  @Test
  void tuplesThatAreNotAllowedAreReported() {
    // Two reads need three steps.
    String dead = MODEL.formatted("").replace("length=\"5\"", "length=\"2\"");

    assertThat(generate(dead).notes())
        .anySatisfy(
            d -> {
              assertThat(d.line()).isEqualTo(7);
              assertThat(d.message()).contains("2-tuples of steps are not allowed");
            });
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          <guard>enabled</guard>    | <guard>enabled && !enabled</guard>   | 12 | no state that 5 steps reach
          <guard>enabled</guard>    | <guard>enabled + 1</guard>           | 12 | enabled
          <guard>enabled</guard>    | <guard>Index > 1</guard>             | 12 | Index
          state="enabled">true      | state="enabled">1.5                  | 9  | the type of
          state="enabled">true      | state="enabled">Index > 1            | 9  | Index
          !error:NotEnabled         | "off"                                | 13 | the type of
          valid ? 10 * step         | valid ? 10 * stepp                   | 20 | stepp
          <update state="enabled">true</update> | <!-- -->                 | 12 | no state that 5 steps reach
          """)
  void contradictionsAreReportedWithTheirLine(
      String part, String replacement, int line, String message) {
    String xml = MODEL.formatted("").replace(part, replacement.replace("&", "&amp;"));
    assertThat(xml).isNotEqualTo(MODEL.formatted(""));

    InvalidInputException failure =
        catchThrowableOfType(InvalidInputException.class, () -> generate(xml));

    assertThat(failure.diagnostics())
        .anySatisfy(
            d -> {
              assertThat(d.line()).isEqualTo(line);
              assertThat(d.message()).contains(message);
            });
  }

  @Test
  void unusedStatesAndUnreachedValuesAreReported() {
    String xml =
        MODEL
            .formatted("")
            .replace(
                "<call name=\"Enable\">",
                "<state name=\"mode\" type=\"boolean\" initial=\"true\"/><call name=\"Enable\">");

    List<Diagnostic> notes = generate(xml).notes();

    assertThat(notes).anyMatch(d -> d.line() == 9 && d.message().contains("is never used"));
    assertThat(notes)
        .anyMatch(d -> d.line() == 9 && d.message().contains("reaches the value false"));
  }

  @Test
  void tooManyStatesAreRefusedWithNumbers() {
    String xml =
        """
        <test_model><name>M</name><input_spec_list/>
          <sequence_spec length="200" order="2"><state name="n" type="int" initial="0"/>
            <call name="A"><update state="n">2 * n</update></call>
            <call name="B"><update state="n">2 * n + 1</update></call></sequence_spec>
          <order_of_combinations>1</order_of_combinations></test_model>
        """;

    assertThatThrownBy(() -> generate(xml)).hasMessageContaining("more than 5,000 abstract states");
  }

  @Test
  void anInterruptionStopsTheGeneration() {
    Thread.currentThread().interrupt();
    try {
      assertThatThrownBy(() -> generate(MODEL.formatted("")))
          .isInstanceOf(CancellationException.class);
    } finally {
      assertThat(Thread.interrupted()).isTrue();
    }
  }
}
