package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * Generates, compiles and runs test applications of a component without a world, with required
 * interfaces and all types.
 */
class GeneratedHarnessTest {
  private static final String PROFILE =
      """
      name: steering
      component:
        language: java
        sources: component/
        class: robot.Steering
        properties: {Gain: 0.5}
        life_cycle: suite
        before: ['Calibrate(3, "left, right", -7)']
      provided: [provided.xml]
      required: [required.xml]
      models: [model.xml]
      """;

  private static final String PROVIDED =
      """
      <service_port_type_profile><service_port_type><type_name>SteeringService</type_name>
        <method name="Calibrate" return_type="void"><param index="1"><name>level</name><type>short</type></param>
          <param index="2"><name>sides</name><type>string</type></param>
          <param index="3"><name>offset</name><type>int64</type></param></method>
        <method name="Steer" return_type="double">
          <param index="1"><name>default</name><type>int</type></param>
          <param index="2"><name>result</name><type>double&amp;</type></param>
          <param index="3"><name>path</name><type>vector&lt;double&gt;</type></param></method>
      </service_port_type></service_port_type_profile>
      """;

  private static final String REQUIRED =
      """
      <service_port_type_profile><service_port_type><type_name>RangeFinder</type_name>
        <method name="GetRange" return_type="double"><param index="1"><name>class</name><type>int</type></param></method>
        <method name="Name" return_type="string"/>
        <method name="Count" return_type="uint64"/>
        <method name="Ranges" return_type="vector&lt;float&gt;"><param index="1"><name>out</name><type>unsigned short&amp;</type></param></method>
        <method name="Stop" return_type="void"/>
      </service_port_type></service_port_type_profile>
      """;

  private static final String COMPONENT =
      """
      package robot;

      import org.sitaf.runtime.Out;
      import sitaf.interfaces.RangeFinder;

      public final class Steering {
        private final RangeFinder finder;
        private double gain;
        private String calibration = "";

        public Steering(RangeFinder finder) {
          this.finder = finder;
        }

        public void setGain(double gain) {
          this.gain = gain;
        }

        public void Calibrate(short level, String sides, long offset) {
          calibration += level + sides + offset;
        }

        public double Steer(int start, Out<Double> result, double[] path) {
          if (!calibration.equals("3left, right-7")) {
            throw new IllegalStateException("calibrated as " + calibration);
          }
          finder.Stop();
          if (finder.Count().signum() != 0 || !finder.Name().isEmpty()) {
            throw new IllegalStateException("an answer that was not set");
          }
          double range = finder.GetRange(start);
          if (range < 0) {
            throw new IllegalArgumentException("range " + range);
          }
          result.set(path.length == 0 ? -1 : path[path.length - 1]);
          return start + gain * range;
        }
      }
      """;

  private static final String MODEL =
      """
      <test_model><name>Steer</name><target interface="SteeringService" method="Steer"/>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int"><name>default</name><type>TDI</type>
            <user_value_list><value>10</value></user_value_list></test_element>
          <test_element abstract_type="STRING" real_type="vector&lt;double&gt;"><name>path</name><type>TDI</type>
            <user_value_list><value>[1, 2.5]</value></user_value_list></test_element>
          <test_element abstract_type="NUMERIC" real_type="double"><name>RangeFinder.GetRange</name><type>TDTS</type>
            <user_value_list><value>4</value><value>-4</value></user_value_list></test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
            <expected>12.0</expected></test_element>
          <test_element abstract_type="NUMERIC" real_type="double"><name>result</name><type>OUT</type>
            <expected>2.25</expected><tolerance absolute="0.1" relative="0"/></test_element>
        </output_spec_list>
        <order_of_combinations>all</order_of_combinations>
      </test_model>
      """;

  @TempDir Path folder;

  private static Map<String, String> files() {
    return new HashMap<>(
        Map.of(
            "activity.yaml", PROFILE,
            "provided.xml", PROVIDED,
            "required.xml", REQUIRED,
            "model.xml", MODEL,
            "component/robot/Steering.java", COMPONENT));
  }

  private static TestApplication generate(Map<String, String> files) {
    Activity activity = Activity.read(HarnessBuild.tree(files));
    var model = activity.models().get(0);
    return InterfaceTestApplicationGenerator.generate(
        activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
  }

  @Test
  void runsAStubbedComponentWithOutParametersSequencesAndSetUp() throws Exception {
    TestApplication application = generate(files());
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    List<String> lines = build.run(application);
    assertThat(lines).hasSize(2);
    String rejectedCase =
        lines.stream().filter(l -> l.contains("range -4.0")).findFirst().orElseThrow();
    String passedCase =
        lines.stream().filter(l -> !l.equals(rejectedCase)).findFirst().orElseThrow();
    assertThat(passedCase)
        .contains("outcome=\"RETURNED\"")
        .contains("<actual name=\"return\">12.0</actual><actual name=\"result\">2.5</actual>");
    assertThat(rejectedCase)
        .contains("outcome=\"THREW\"><thrown>IllegalArgumentException</thrown>")
        .contains(
            "java.lang.IllegalArgumentException: range -4.0 at"
                + " robot.Steering.Steer(Steering.java:");
  }

  @Test
  void requiredInterfacesAreJavaInterfaces() {
    assertThat(generate(files()).harness().text("sitaf/interfaces/RangeFinder.java"))
        .contains(
            """
            package sitaf.interfaces;

            import java.math.BigInteger;
            import org.sitaf.runtime.Out;

            /** The required interface RangeFinder, described in required.xml. */
            public interface RangeFinder {
              double GetRange(int classValue);

              String Name();

              BigInteger Count();

              float[] Ranges(Out<Integer> out);

              void Stop();
            }
            """);
  }

  @Test
  void reportsAnUndefinedTypeWithItsMethod() {
    Map<String, String> files = files();
    files.put("provided.xml", PROVIDED.replace("vector&lt;double&gt;", "PointCloud"));
    assertThatThrownBy(() -> generate(files))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("provided.xml:5: ")
        .hasMessageContaining("PointCloud");
  }

  @Test
  void rejectsAnInvalidSetUpCall() {
    for (String call :
        List.of(
            "Start()",
            "Calibrate(3)",
            "Calibrate(70000, \"a\", 1)",
            "Calibrate(3; \"a\"",
            "a.b()",
            "Steer(1, 2, 3)")) {
      Map<String, String> files = files();
      files.put(
          "activity.yaml",
          PROFILE.replace("'Calibrate(3, \"left, right\", -7)'", "'" + call + "'"));
      assertThatThrownBy(() -> generate(files))
          .as(call)
          .isInstanceOf(InvalidInputException.class)
          .hasMessageContaining("activity.yaml")
          .hasMessageContaining("before");
    }
  }

  @Test
  void aPeriodicComponentNeedsAWorld() {
    Map<String, String> files = files();
    assertThat(PROFILE).contains("component:\n");
    files.put(
        "activity.yaml",
        PROFILE.replace("component:\n", "component:\n  execution: periodic\n  period_ms: 100\n"));
    assertThatThrownBy(() -> generate(files))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("component.execution");
  }
}
