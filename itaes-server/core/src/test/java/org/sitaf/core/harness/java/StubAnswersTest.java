package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;

/** Errors and delays as answers of test stubs, from the model to the run. */
class StubAnswersTest {
  private static final Map<String, String> FILES =
      Map.of(
          "activity.yaml",
          """
          name: watcher
          component: {language: java, sources: component/, class: robot.Watcher}
          provided: [watcher.idl]
          required: [sensors.idl]
          models: [model.xml]
          """,
          "watcher.idl",
          "interface Watcher { string Watch(); };",
          "sensors.idl",
          """
          enum Mode { SLEEP, WAKE };
          module hw { exception NoEcho {}; };
          interface Sensors {
            double Range() raises (hw::NoEcho);
            octet Level() raises (hw::NoEcho);
            boolean Bumped() raises (hw::NoEcho);
            string Label() raises (hw::NoEcho);
            Mode Current() raises (hw::NoEcho);
          };
          """,
          "model.xml",
          """
          <test_model><name>Watch</name>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>Sensors.Range</name><type>TDTS</type>
                <test_spec type="BVA" offset="0.5"><equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="1" max="3"/></test_spec>
                <user_value_list><value>!error:NoEcho</value><value>!delay:0.001 2.5</value></user_value_list></test_element>
              <test_element abstract_type="NUMERIC" real_type="uint8"><name>Sensors.Level</name><type>TDTS</type>
                <user_value_list><value>!error:NoEcho</value><value>7</value></user_value_list></test_element>
              <test_element abstract_type="BOOLEAN" real_type="boolean"><name>Sensors.Bumped</name><type>TDTS</type>
                <user_value_list><value>!delay:0.001 true</value><value>!error:NoEcho</value></user_value_list></test_element>
              <test_element abstract_type="STRING" real_type="string"><name>Sensors.Label</name><type>TDTS</type>
                <test_spec type="RANDOM_STRING" min_length="1" max_length="3" alphabet="true" number="false" special_char="false" space="false"/>
                <user_value_list><value>!error:NoEcho</value></user_value_list></test_element>
              <test_element abstract_type="ENUM" real_type="Mode"><name>Sensors.Current</name><type>TDTS</type>
                <user_value_list><value>WAKE</value><value>!error:NoEcho</value><value>!delay:0.001</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="STRING" real_type="string"><name>return</name><type>RETURN</type>
                <expected>string(Sensors.Range == "!error:NoEcho") + " " + string(Sensors.Level == "!error:NoEcho") + " "
                  + string(Sensors.Bumped == "!error:NoEcho") + " " + string(Sensors.Label == "!error:NoEcho") + " "
                  + string(Sensors.Current == "!error:NoEcho")</expected></test_element>
            </output_spec_list>
            <order_of_combinations>2</order_of_combinations>
          </test_model>
          """,
          "component/robot/Watcher.java",
          """
          package robot;

          import sitaf.interfaces.NoEcho;
          import sitaf.interfaces.Sensors;

          public final class Watcher {
            private interface Ask {
              Object answer() throws NoEcho;
            }

            private final Sensors sensors;

            public Watcher(Sensors sensors) {
              this.sensors = sensors;
            }

            private static boolean fails(Ask ask) {
              try {
                ask.answer();
                return false;
              } catch (NoEcho e) {
                return true;
              }
            }

            public String Watch() {
              return fails(sensors::Range)
                  + " " + fails(sensors::Level)
                  + " " + fails(sensors::Bumped)
                  + " " + fails(sensors::Label)
                  + " " + fails(sensors::Current);
            }
          }
          """);

  @TempDir Path folder;

  private static Activity activity() {
    return Activity.read(HarnessBuild.tree(FILES));
  }

  private static TestSuite suite(TestModel model) {
    return TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
  }

  @Test
  void theSuiteContainsErrorsAndDelaysAsValidValues() {
    TestSuite suite = suite(activity().models().get(0));
    assertThat(suite.cases())
        .flatExtracting(TestCase::values)
        .contains("!error:NoEcho", "!delay:0.001 2.5", "!delay:0.001 true", "!delay:0.001");
    for (int column = 0; column < suite.parameters().size(); column++) {
      int at = column;
      assertThat(suite.cases())
          .as(suite.parameters().get(column).name())
          .anyMatch(c -> c.valid() && c.values().get(at).equals("!error:NoEcho"));
    }
  }

  @Test
  void keepsAnEarlierSuiteWithErrorsAndDelays() {
    TestModel model = activity().models().get(0);
    TestSuite earlier = suite(model);
    var again =
        TestCaseGenerator.generate(
            model, new GenerationOptions(null, null, 1, Effort.DEFAULT, earlier));
    assertThat(again.suite().cases()).isEqualTo(earlier.cases());
  }

  @Test
  void exceptionsHaveNoScopeAndAmbiguousNamesAreRejected() {
    Activity activity = activity();
    TestModel model = activity.models().get(0);
    assertThat(
            InterfaceTestApplicationGenerator.generate(activity, model, suite(model))
                .harness()
                .text("sitaf/interfaces/Sensors.java")
                .orElseThrow())
        .contains("double Range() throws NoEcho;");
    Map<String, String> files = new HashMap<>(FILES);
    files.put(
        "watcher.idl",
        "module sw { exception NoEcho {}; };"
            + " interface Watcher { string Watch() raises (sw::NoEcho); };");
    Activity twice = Activity.read(HarnessBuild.tree(files));
    assertThatThrownBy(() -> InterfaceTestApplicationGenerator.generate(twice, model, suite(model)))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining(
            "the exceptions sw::NoEcho and hw::NoEcho have the same name in a test");
  }

  @Tag("slow")
  @Test
  void theStubThrowsAndWaits() throws Exception {
    Activity activity = activity();
    TestModel model = activity.models().get(0);
    TestSuite suite = suite(model);
    TestApplication application =
        InterfaceTestApplicationGenerator.generate(activity, model, suite);
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    assertThat(build.run(application))
        .hasSameSizeAs(suite.cases())
        .allMatch(line -> line.contains("outcome=\"RETURNED\""))
        .anyMatch(line -> line.contains("<actual name=\"return\">true "))
        .anyMatch(line -> line.contains("<actual name=\"return\">false "));
  }
}
