package org.sitaf.core.model.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceEvent;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateVariable;

class SequenceReaderTest {
  /** One line per element, so that each problem has a line of its own. */
  private static final String MODEL =
      """
      <test_model>
        <name>LifeCycle</name>
        <target interface="InfraredSensorService"/>
        <input_spec_list/>
        <sequence_spec length="6" order="3">
          <state name="enabled" type="boolean" initial="false"/>
          <call name="Enable"><update state="enabled">true</update></call>
          <call name="Disable"><update state="enabled">false</update></call>
          <call name="Read" method="GetInfraredData" run_for="0.1" overlap="true">
            <guard>enabled</guard>
            <forbidden>!error:NotEnabled</forbidden>
            <pre_condition_spec_list>
              <pre_condition>IndexOfSensor != 5</pre_condition>
            </pre_condition_spec_list>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int"><name>IndexOfSensor</name><type>TDI</type>
                <user_value_list><value>1</value><value>2</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type></test_element>
            </output_spec_list>
            <post_condition_spec_list>
              <post_condition>actual &gt;= 0.0</post_condition>
            </post_condition_spec_list>
          </call>
          <event name="ObstacleNears" set="Distance" to="0.5"/>
          <event name="DropsOut" set="fault.ir1.dropout" to="1"><guard>!enabled</guard></event>
        </sequence_spec>
        <post_condition_spec_list>
          <post_condition>steps.size() > 0</post_condition>
        </post_condition_spec_list>
        <order_of_combinations>2</order_of_combinations>
        <case_list>
          <case no="4"><step name="Enable"/><step name="Read"><value>2</value></step></case>
        </case_list>
      </test_model>
      """;

  private static TestModel read(String xml) {
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
  }

  private static SequenceSpec sequence(TestModel model) {
    return Objects.requireNonNull(model.sequence());
  }

  @Test
  void everyPartIsRead() {
    TestModel model = read(MODEL);
    SequenceSpec sequence = sequence(model);

    assertThat(sequence.length()).isEqualTo(6);
    assertThat(sequence.order()).isEqualTo(3);
    assertThat(sequence.repeat()).isTrue();
    assertThat(sequence.threads()).isEqualTo(1);
    assertThat(sequence.states()).extracting(StateVariable::name).containsExactly("enabled");
    assertThat(sequence.calls())
        .extracting(SequenceCall::name)
        .containsExactly("Enable", "Disable", "Read");
    assertThat(sequence.events())
        .extracting(SequenceEvent::set)
        .containsExactly("Distance", "fault.ir1.dropout");
    assertThat(sequence.events().get(1).isFault()).isTrue();
    assertThat(sequence.events().get(1).guard()).isNotNull();
  }

  @Test
  void aCallHasATestModelOfItsOwn() {
    SequenceCall read = sequence(read(MODEL)).call("Read").orElseThrow();
    TestModel model = read.model();

    assertThat(read.overlap()).isTrue();
    assertThat(Objects.requireNonNull(read.guard()).line()).isEqualTo(10);
    assertThat(Objects.requireNonNull(read.forbidden()).line()).isEqualTo(11);
    assertThat(model.target().interfaceName()).isEqualTo("InfraredSensorService");
    assertThat(model.target().method()).isEqualTo("GetInfraredData");
    assertThat(model.target().runFor()).isEqualTo(Duration.ofMillis(100));
    assertThat(model.inputs()).extracting(InputElement::name).containsExactly("IndexOfSensor");
    assertThat(model.strength()).isEqualTo(new Strength(2));
    assertThat(model.surroundings()).containsOnlyKeys("enabled", "step");
  }

  @Test
  void conditionsHaveTheirLines() {
    TestModel model = read(MODEL);
    TestModel call = sequence(model).call("Read").orElseThrow().model();

    assertThat(call.preConditions().get(0).line()).isEqualTo(13);
    assertThat(call.postConditions().get(0).line()).isEqualTo(23);
    assertThat(model.postConditions().get(0).line()).isEqualTo(30);
  }

  @Test
  void keptCasesHaveSteps() {
    KeptCase kept = read(MODEL).keptCases().get(0);

    assertThat(kept.no()).isEqualTo(4);
    assertThat(kept.steps()).extracting(KeptCase.Step::name).containsExactly("Enable", "Read");
    assertThat(kept.steps().get(1).values().get(0).literal()).isEqualTo("2");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          length="6"                 | length="2"                          | 5  | no sequence of 2 steps holds 3
          length="6"                 | length="many"                       | 5  | many
          order="3"                  | order="6" repeat="false"            | 5  | no 6 distinct steps
          order="3"                  | order="7"                           | 5  | must be at most 6
          order="3"                  | order="3" threads="0"               | 5  | must be a whole number from 1
          type="boolean"             | type="void"                         | 6  | the type must be
          initial="false"            | initial="off"                       | 6  | not true or false
          name="enabled"             | name="step"                         | 6  | use this name for something else
          <update state="enabled">true | <update state="enable">true       | 7  | there is no state 'enable'
          <update state="enabled">true | <update state="enabled">          | 7  | has no expression
          <call name="Disable">      | <call name="Enable">                | 8  | another one has this name
          <call name="Disable">      | <call name="2nd">                   | 8  | letters, digits and '_'
          run_for="0.1"              | run_for="-1"                        | 9  | must be 0 to 1000000
          <guard>enabled</guard>     | <!-- -->                            | 11 | without a guard
          <event name="ObstacleNears"| <event name="Read"                  | 26 | another one has this name
          to="0.5"                   | to="near"                           | 26 | near
          <input_spec_list/>         | <input_spec_list/><max_cases>9</max_cases> | 0 | does not bound sequences
          interface="InfraredSensorService" | interface="A" method="Read"  | 3  | have no effect with a sequence_spec
          <step name="Enable"/>      | <step name="Enabled"/>              | 34 | neither a call nor an event
          <step name="Enable"/>      | <step name="Enable"><value>1</value></step> | 34 | has 1 values for 0
          """)
  void problemsNameTheirLine(String part, String replacement, int line, String message) {
    String xml = MODEL.replace(part, replacement);
    assertThat(xml).isNotEqualTo(MODEL);

    InvalidInputException failure =
        catchThrowableOfType(InvalidInputException.class, () -> read(xml));

    List<Diagnostic> found =
        failure.diagnostics().stream().filter(d -> d.message().contains(message)).toList();
    assertThat(found).as(failure.getMessage()).isNotEmpty();
    assertThat(found.get(0).line()).isEqualTo(line);
  }

  @Test
  void aStateMayNotHaveTheNameOfAnInput() {
    String xml = MODEL.replace("name=\"enabled\"", "name=\"IndexOfSensor\"");

    assertThat(catchThrowableOfType(InvalidInputException.class, () -> read(xml)).diagnostics())
        .anySatisfy(
            d -> {
              assertThat(d.line()).isEqualTo(6);
              assertThat(d.message()).contains("an input has this name");
            });
  }

  @Test
  void stepsNeedASequence() {
    String xml =
        """
        <test_model><name>M</name><input_spec_list/>
          <order_of_combinations>1</order_of_combinations>
          <case_list><case><step name="A"/></case></case_list></test_model>
        """;

    assertThat(catchThrowableOfType(InvalidInputException.class, () -> read(xml)).diagnostics())
        .anySatisfy(d -> assertThat(d.message()).contains("no sequence_spec"));
  }
}
