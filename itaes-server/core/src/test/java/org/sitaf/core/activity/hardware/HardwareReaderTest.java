package org.sitaf.core.activity.hardware;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.hardware.DeviceBackend.Kind;
import org.sitaf.core.activity.hardware.DeviceBackend.Range;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/** The entry {@code hardware} of activity.yaml, and what a result says about real devices. */
class HardwareReaderTest {
  private static final String MODEL =
      """
      <test_model><name>Drive</name>
        <input_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>Distance</name><type>TDSD</type>
          <user_value_list><value>1</value></user_value_list></test_element></input_spec_list>
        <output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
          <expected>0.0</expected></test_element></output_spec_list>
        %s
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private static final String CLOSE =
      """
      <trajectory_condition_spec_list>
        <trajectory_condition name="close">always(ir1.shadow_error &lt;= 0.1)</trajectory_condition>
      </trajectory_condition_spec_list>
      """;

  private final Map<String, String> files =
      new HashMap<>(
          Map.of(
              "service.xml",
              """
              <service_port_type>
                <type_name>RobotService</type_name>
                <method name="Drive" return_type="double"/>
              </service_port_type>
              """,
              "world/w.world.yaml",
              """
              mjcf: w.xml
              parameters:
                Distance: {unit: m, range: [0, 9], default: 1, bind: {set: body.b.pos.x}}
              devices:
                ir1: {kind: range, sensor: ir1}
                eye: {kind: camera, camera: c}
                arm: {kind: joint_motor, actuator: a}
              """,
              "world/w.xml",
              "<mujoco/>",
              "imu.csv",
              "t,range",
              "bag.mcap",
              "",
              "component/robot/Robot.java",
              "package robot; public class Robot {}"));

  private Activity read(String lines, String conditions) {
    files.put(
        "activity.yaml",
        """
        name: robot
        component: {language: java, sources: component/, class: robot.Robot}
        provided: [service.xml]
        world: world/w.world.yaml
        models: [Drive.xml]
        """
            + lines);
    files.put("Drive.xml", MODEL.formatted(conditions));
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activity.read(FileTree.of(bytes));
  }

  private String problems(String lines, String conditions) {
    InvalidInputException thrown =
        catchThrowableOfType(InvalidInputException.class, () -> read(lines, conditions));
    return thrown == null
        ? ""
        : String.join("; ", thrown.diagnostics().stream().map(Diagnostic::toString).toList());
  }

  @Test
  void eachBackendIsRead() {
    List<DeviceBackend> backends =
        read(
                """
                hardware:
                  ir1: {backend: shadow, address: "unix:/run/ir1.sock", max_age_s: 0.05, independent_of: [Distance]}
                  arm:
                    backend: provider
                    address: localhost:7000
                    envelope: {velocity: [-1, 0.5], effort: 3, rate: {velocity: 4}}
                """,
                CLOSE)
            .profile()
            .hardware();

    DeviceBackend shadow = backends.get(0);
    assertThat(shadow.kind()).isEqualTo(Kind.SHADOW);
    assertThat(shadow.address()).isEqualTo("unix:/run/ir1.sock");
    assertThat(shadow.maxAgeS()).isEqualTo(0.05);
    assertThat(shadow.independentOf()).containsExactly("Distance");
    DeviceBackend arm = backends.get(1);
    assertThat(arm.kind()).isEqualTo(Kind.PROVIDER);
    assertThat(arm.maxAgeS()).isEqualTo(DeviceBackend.DEFAULT_MAX_AGE_S);
    assertThat(arm.envelope())
        .containsOnly(
            Map.entry("velocity", new Range(-1, 0.5)), Map.entry("effort", new Range(-3, 3)));
    assertThat(arm.rates()).containsOnly(Map.entry("velocity", 4.0));
  }

  @Test
  void aSimulatedDeviceNeedsNothing() {
    assertThat(read("hardware: {ir1: {backend: sim}}", "").profile().hardware()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "ir9: {backend: provider}                            | has no such device; did you mean"
            + " 'ir1'?",
        "ir1: {backend: provder}                             | not 'provder'; did you mean"
            + " 'provider'?",
        "ir1: {address: 'unix:/x'}                           | hardware.ir1.backend: is missing",
        "ir1: {backend: provider, adress: x}                 | unknown entry; did you mean"
            + " 'address'?",
        "ir1: {backend: sim, max_age_s: 1}                   | unknown entry",
        "ir1: {backend: provider, address: /tmp/x}           | '/tmp/x' is not an address",
        "ir1: {backend: provider, max_age_s: 0}              | must be above 0 and at most 3600",
        "ir1: {backend: provider, envelope: {velocity: 1}}   | commands of a range have no number"
            + " 'velocity'",
        "arm: {backend: provider, envelope: {velcity: 1}}    | no number 'velcity'; did you mean"
            + " 'velocity'?",
        "arm: {backend: provider, envelope: {velocity: [1]}} | must be plain text",
        "arm: {backend: provider, envelope: {velocity: [2, 1]}} | must be [MIN, MAX]",
        "arm: {backend: provider, envelope: {rate: {velocity: -1}}} | must be above 0",
        "eye: {backend: provider}                            | is a camera, which can only be"
            + " simulated",
        "ir1: {backend: replay}                              | hardware.ir1.file: is missing",
        "ir1: {backend: replay, file: no.csv}                | 'no.csv' does not exist in the"
            + " activity",
        "ir1: {backend: replay, file: imu.txt}               | must be a .csv or .mcap file",
        "ir1: {backend: replay, file: bag.mcap}              | names the topic of an MCAP file; add"
            + " it",
        "ir1: {backend: replay, file: imu.csv, topic: /x}    | is only for .mcap",
        "ir1: {backend: provider, independent_of: [Distnce]} | no parameter 'Distnce'; did you mean"
            + " 'Distance'?",
      })
  void whatCannotWorkIsReportedWithItsLine(String line, String message) {
    String found = problems("hardware:\n  " + line + "\n", "");
    assertThat(found).contains(message).contains("activity.yaml:7");
  }

  @Test
  void whatARealDeviceCannotDoIsRefused() {
    String real = "hardware: {ir1: {backend: provider, address: \"unix:/x\"}}\n";
    assertThat(problems(real + "parallel: true\n", "")).contains("serves one case at a time");
    assertThat(problems(real, CLOSE)).contains("ir1.shadow_error");
    assertThat(
            problems(
                real,
                """
                <relation_list><relation name="same"><change name="Distance">Distance</change>
                  <holds>after.value == before.value</holds></relation></relation_list>
                """))
        .contains("compares two runs");
  }

  @Test
  void aResultKeepsWhatWasMeasured() {
    Activity activity = read("", "");
    var suite =
        TestCaseGenerator.generate(activity.models().get(0), GenerationOptions.DEFAULT).suite();
    ResultAssembler assembler = new ResultAssembler(activity.models().get(0), suite);
    HardwareReport report =
        new HardwareReport(
            List.of("ir1: a real device"), 5, 0.001, 0.02, 1, 7, 0.03, 2, 3, 4, List.of("lost"));
    CaseResult result = assembler.without(1, Verdict.DONT, "infrastructure: lost").with(report);
    TestResult whole =
        assembler.assemble(
            List.of(result), "", new Provenance("", 1, "", "", "", "", "", List.of(), "", ""));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestResultXml.write(whole, out);

    TestResult again = TestResultXml.read(new ByteArrayInputStream(out.toByteArray()), "r.xml");

    assertThat(again.cases().get(0).hardware()).isEqualTo(report);
    assertThat(again.cases().get(0).message()).isEqualTo("infrastructure: lost");
    HardwareReport sum = HardwareReport.of(List.of(result, result)).orElseThrow();
    assertThat(sum.exchanges()).isEqualTo(10);
    assertThat(sum.meanJitter()).isEqualTo(0.001);
    assertThat(sum.safeStops()).isEqualTo(8);
    assertThat(sum.faults()).containsExactly("lost");
    assertThat(report.text()).contains("jitter at most 20.00 ms").contains("4 safe stops");
  }
}
