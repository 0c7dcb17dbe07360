package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * Generates and runs harnesses with structs, enumerations, exceptions and stubs with several
 * answers.
 */
@Tag("slow")
class StructuredHarnessTest {
  private static final String PROFILE =
      """
      name: planner
      component:
        language: java
        sources: component/
        class: robot.Planner
        before: [Configure(FAST)]
      provided: [planner.idl]
      required: [map.idl]
      models: [model.xml]
      """;

  private static final String PLANNER =
      """
      enum Speed { SLOW, FAST };
      struct Point { double x; double y; };
      struct Pose { Point position; double heading; string label; };
      typedef sequence<Pose> Poses;
      exception NoWay {};
      interface Planner {
        void Configure(in Speed speed);
        Poses Plan(in Pose from, in sequence<Point> via, out long count, in Speed speed) raises (NoWay);
      };
      """;

  private static final String MAP =
      """
      exception Unmapped {};
      struct Cell { double cost; boolean free; };
      interface Map {
        Cell Look(in double x, in double y, out long age) raises (Unmapped);
        oneway void Release();
      };
      """;

  private static final String COMPONENT =
      """
      package robot;

      import org.sitaf.runtime.Out;
      import sitaf.interfaces.Cell;
      import sitaf.interfaces.GridMap;
      import sitaf.interfaces.NoWay;
      import sitaf.interfaces.Point;
      import sitaf.interfaces.Pose;
      import sitaf.interfaces.Speed;
      import sitaf.interfaces.Unmapped;

      public final class Planner {
        private final GridMap map;
        private boolean started;
        private Speed speed = Speed.SLOW;

        public Planner(GridMap map) {
          this.map = map;
        }

        public void start() {
          started = true;
        }

        public void Configure(Speed speed) {
          if (!started) {
            throw new IllegalStateException("configured before it was started");
          }
          this.speed = speed;
        }

        public Pose[] Plan(Pose from, Point[] via, Out<Integer> count, Speed speed) {
          if (this.speed != Speed.FAST || speed != Speed.SLOW) {
            throw new IllegalStateException("speed");
          }
          Pose[] poses = new Pose[via.length];
          int ages = 0;
          for (int i = 0; i < via.length; i++) {
            Out<Integer> age = new Out<>();
            Cell cell;
            try {
              cell = map.Look(via[i].x(), via[i].y(), age);
            } catch (Unmapped e) {
              throw new NoWay("at " + i);
            }
            ages += age.get();
            poses[i] = new Pose(via[i], cell.cost(), from.label() + i);
          }
          map.Release();
          count.set(ages);
          return poses;
        }
      }
      """;

  private static final String MODEL =
      """
      <test_model><name>Plan</name><target interface="Planner" method="Plan"/>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double"><name>from.position.x</name><type>TDI</type>
            <user_value_list><value>1.5</value></user_value_list></test_element>
          <test_element abstract_type="STRING" real_type="string"><name>from.label</name><type>TDI</type>
            <user_value_list><value>a, "b}</value></user_value_list></test_element>
          <test_element abstract_type="STRUCT" real_type="sequence&lt;Point&gt;"><name>via</name><type>TDI</type>
            <user_value_list><value>[{y: 2, x: 1}, {x: 3}]</value></user_value_list></test_element>
          <test_element abstract_type="ENUM" real_type="Speed"><name>speed</name><type>TDI</type>
            <user_value_list><value>SLOW</value></user_value_list></test_element>
          <test_element abstract_type="STRUCT" real_type="Cell"><name>GridMap.Look</name><type>TDTS</type>
            <user_value_list><value>{cost: 0.5, free: true}</value><value>!error:Unmapped</value></user_value_list></test_element>
          <test_element abstract_type="STRUCT" real_type="Cell"><name>GridMap.Look#2</name><type>TDTS</type>
            <user_value_list><value>!delay:0.02 {cost: NaN}</value></user_value_list></test_element>
          <test_element abstract_type="NUMERIC" real_type="int"><name>GridMap.Look.age</name><type>TDTS</type>
            <user_value_list><value>7</value></user_value_list></test_element>
          <test_element abstract_type="STRING" real_type="string"><name>GridMap.Release</name><type>TDTS</type>
            <user_value_list><value>!delay:0.001</value></user_value_list></test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="STRUCT" real_type="sequence&lt;Pose&gt;"><name>return</name><type>RETURN</type>
            <expected>GridMap.Look == "!error:Unmapped" ? "!error:NoWay"
              : [{"position": {"x": 1.0, "y": 2.0}, "heading": 0.5}, {"heading": 0.0/0.0, "label": "a, \\"b}1"}]</expected></test_element>
          <test_element abstract_type="NUMERIC" real_type="double"><name>return[1].position.x</name><type>RETURN</type>
            <expected>4.0</expected></test_element>
          <test_element abstract_type="NUMERIC" real_type="int"><name>count</name><type>OUT</type>
            <expected>14</expected></test_element>
        </output_spec_list>
        <order_of_combinations>all</order_of_combinations>
      </test_model>
      """;

  @TempDir Path folder;

  private static Map<String, String> files() {
    return new HashMap<>(
        Map.of(
            "activity.yaml", PROFILE,
            "planner.idl", PLANNER,
            "map.idl", MAP.replace("interface Map", "interface GridMap"),
            "model.xml", MODEL,
            "component/robot/Planner.java", COMPONENT));
  }

  private static TestApplication generate(Map<String, String> files) {
    Activity activity = Activity.read(HarnessBuild.tree(files));
    var model = activity.models().get(0);
    return InterfaceTestApplicationGenerator.generate(
        activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
  }

  @Test
  void runsWithMembersErrorsAndAnswersOfLaterCalls() throws Exception {
    TestApplication application = generate(files());
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    List<String> lines = build.run(application);
    assertThat(lines).hasSize(2);
    String thrown = lines.stream().filter(l -> l.contains("<thrown>")).findFirst().orElseThrow();
    String planned = lines.stream().filter(l -> !l.equals(thrown)).findFirst().orElseThrow();
    assertThat(thrown)
        .contains("outcome=\"THREW\"><thrown>NoWay</thrown>")
        .contains("<argument name=\"x\">1.0</argument><argument name=\"y\">2.0</argument></call>")
        .doesNotContain("GridMap.Release\"");
    assertThat(planned)
        .contains("outcome=\"RETURNED\"")
        .contains("<actual name=\"return[1].position.x\">3.0</actual>")
        .contains(
            "[{position: {x: 1.0, y: 2.0}, heading: 0.5, label: &quot;a, \\&quot;b}0&quot;},"
                + " {position: {x: 3.0, y: 0.0}, heading: NaN, label: &quot;a, \\&quot;b}1&quot;}]")
        .contains("<actual name=\"count\">14</actual>")
        .contains("<call method=\"GridMap.Release\"></call>");
    double stub = Double.parseDouble(planned.replaceFirst("(?s).* stub=\"([0-9.]+)\".*", "$1"));
    assertThat(stub).as("delays count as time of the stub").isGreaterThan(20_000);
  }

  @Test
  void aGeneratedAdapterCompilesAndReportsWhatIsMissing() throws Exception {
    Map<String, String> files = files();
    files.put(
        "activity.yaml",
        PROFILE
            .replace("class: robot.Planner", "class: bound.PlannerAdapter\n  adapter: adapter/")
            .replace("  before: [Configure(FAST)]\n", ""));
    var adapter =
        InterfaceTestApplicationGenerator.adapter(
            Activity.readWithoutComponent(HarnessBuild.tree(files)));
    files.remove("component/robot/Planner.java");
    files.put("component/robot/Unbound.java", "package robot; final class Unbound {}");
    files.put(
        "adapter/bound/PlannerAdapter.java",
        adapter.text("adapter/bound/PlannerAdapter.java").orElseThrow());
    TestApplication application = generate(files);
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    assertThat(build.run(application))
        .hasSize(2)
        .allMatch(line -> line.contains("outcome=\"THREW\""))
        .allMatch(line -> line.contains("Plan is not implemented yet"));
  }

  @Test
  void theSourcesAreReadable() {
    TestApplication application = generate(files());
    assertThat(application.harness().text("sitaf/harness/plan/TestDriver.java").orElseThrow())
        .contains("Pose from = new Pose(new Point(fromPositionX, 0.0), 0.0, fromLabel);")
        .contains("Point[] via = testCase.value(\"via\", Point[].class);")
        .contains("Speed speed = testCase.value(\"speed\", Speed.class);")
        .contains("result.recordPart(\"return[1].position.x\", returned);");
    assertThat(application.harness().text("sitaf/interfaces/Pose.java"))
        .contains(
            """
            package sitaf.interfaces;

            /** The type Pose of the component's interfaces. */
            public record Pose(Point position, double heading, String label) {
              /** Sets all members to zero. */
              public Pose() {
                this(new Point(), 0.0, "");
              }
            }
            """);
    assertThat(application.harness().text("sitaf/interfaces/GridMap.java").orElseThrow())
        .contains("Cell Look(double x, double y, Out<Integer> age) throws Unmapped;");
  }

  @Test
  void aNonblockingCallRunsInItsOwnThread() throws Exception {
    Map<String, String> files = files();
    files.put(
        "planner.idl",
        PLANNER.replace("};\n      };", "};")
            + "interface Begin { oneway void Go(in double x); };");
    files.put(
        "component/robot/Planner.java",
        COMPONENT.replace(
            "public void start()",
            """
            public void Go(double x) {
              if (!Thread.currentThread().getName().equals("call under test")) {
                throw new IllegalStateException("in the driver's thread");
              }
              map.Release();
            }

            public void start()\
            """));
    files.put(
        "model.xml",
        """
        <test_model><name>Go</name><target interface="Begin" method="Go"/>
          <input_spec_list>
            <test_element abstract_type="NUMERIC" real_type="double"><name>x</name><type>TDI</type>
              <user_value_list><value>1</value></user_value_list></test_element>
          </input_spec_list>
          <output_spec_list/>
          <order_of_combinations>all</order_of_combinations>
        </test_model>
        """);
    TestApplication application = generate(files);
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    assertThat(build.run(application))
        .singleElement()
        .asString()
        .contains("outcome=\"RETURNED\"")
        .contains("GridMap.Release");
  }
}
