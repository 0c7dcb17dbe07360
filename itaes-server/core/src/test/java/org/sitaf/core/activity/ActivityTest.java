package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.Timing;

class ActivityTest {
  private final Map<String, String> files = new HashMap<>();

  ActivityTest() throws IOException {
    try (InputStream model = getClass().getResourceAsStream("/models/GetInfraredData.xml")) {
      files.put(
          "GetInfraredData.xml",
          new String(Objects.requireNonNull(model).readAllBytes(), StandardCharsets.UTF_8));
    }
    files.put(
        "activity.yaml",
        """
        name: ir
        component:
          language: java
          sources: component/
          class: robot.Sensor
        provided: [service.xml]
        world: world/ir.world.yaml
        models: [GetInfraredData.xml]
        """);
    files.put(
        "service.xml",
        """
        <service_port_type>
          <type_name>InfraredSensorService</type_name>
          <method name="GetInfraredData" return_type="double">
            <param index="1"><name>IndexOfSensor</name><type>int</type></param>
            <param index="2"><name>NumOfSensor</name><type>int</type></param>
          </method>
        </service_port_type>
        """);
    files.put("component/robot/Sensor.java", "package robot; public class Sensor {}");
    files.put(
        "world/ir.world.yaml",
        """
        mjcf: ir.xml
        parameters:
          Distance: {unit: m, range: [-1, 20], default: 5}
        """);
  }

  private Activity read() {
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activity.read(FileTree.of(bytes));
  }

  private void replace(String path, String from, String to) {
    assertThat(files.get(path)).contains(from);
    files.put(path, files.get(path).replace(from, to));
  }

  private List<String> problems() {
    return catchThrowableOfType(InvalidInputException.class, this::read).diagnostics().stream()
        .map(Diagnostic::toString)
        .toList();
  }

  @Test
  void readsAConsistentActivity() {
    Activity activity = read();
    assertThat(activity.profile().name()).isEqualTo("ir");
    assertThat(activity.models()).hasSize(1);
    assertThat(activity.warnings()).isEmpty();
  }

  @Test
  void readsTheTimeLimitForPreparingPackages() {
    assertThat(read().profile().limits().preparation()).isEqualTo(Duration.ofMinutes(5));
    files.merge("activity.yaml", "limits: {prepare_s: 900}\n", String::concat);
    assertThat(read().profile().limits().preparation()).isEqualTo(Duration.ofMinutes(15));
  }

  @Test
  void reportsAnUnknownMethodWithTheExistingOnes() {
    replace("service.xml", "GetInfraredData", "GetData");
    assertThat(problems())
        .containsExactly(
            "GetInfraredData.xml: error: target: no method GetInfraredData; known methods:"
                + " InfraredSensorService.GetData");
  }

  @Test
  void reportsAnUnknownWorldParameter() {
    replace("world/ir.world.yaml", "Distance", "Gap");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("test_element Distance: world/ir.world.yaml has no such parameter; it has Gap");
  }

  @Test
  void reportsAValueOutsideTheRangeOfTheWorld() {
    replace("world/ir.world.yaml", "[-1, 20]", "[0, 10]");
    assertThat(problems()).hasSize(2).allMatch(p -> p.contains("is outside the range [0.0, 10.0]"));
  }

  @Test
  void reportsATypeThatDoesNotMatchTheInterface() {
    replace(
        "service.xml",
        "<type>int</type></param>\n    <param index=\"2\"",
        "<type>string</type></param>\n    <param index=\"2\"");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains(
            "test_element IndexOfSensor: real_type int does not match the interface, which declares"
                + " string");
  }

  @Test
  void reportsAParameterWithoutTestElement() {
    replace("service.xml", "NumOfSensor", "Count");
    assertThat(problems())
        .anyMatch(
            p -> p.contains("test_element NumOfSensor: GetInfraredData has no such parameter"))
        .anyMatch(p -> p.contains("parameter Count of GetInfraredData has no test_element"));
  }

  private void driveByPoseAndMode(String elements) {
    files.put(
        "service.idl",
        """
        enum Mode { SLOW, FAST };
        struct Pose { double x; double path[2]; };
        interface DriveService { void Drive(in Pose pose, in Mode mode); };
        """);
    replace("activity.yaml", "service.xml", "service.idl");
    files.put(
        "GetInfraredData.xml",
        """
        <test_model><name>Drive</name><input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double"><name>pose.x</name><type>TDI</type>
          <user_value_list><value>1</value></user_value_list></test_element>
        %s
        </input_spec_list><order_of_combinations>2</order_of_combinations></test_model>
        """
            .formatted(elements));
  }

  @Test
  void anEnumerationHasAllLiteralsOfTheInterface() {
    driveByPoseAndMode(
        """
        <test_element abstract_type="ENUM" real_type="Mode"><name>mode</name><type>TDI</type></test_element>
        """);
    TestModel model = read().models().get(0);
    assertThat(
            TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite().cases().stream()
                .map(c -> c.values().get(1)))
        .containsExactlyInAnyOrder("SLOW", "FAST");
  }

  @Test
  void reportsUnknownMembersAndLiterals() {
    driveByPoseAndMode(
        """
        <test_element abstract_type="ENUM" real_type="Mode"><name>mode</name><type>TDI</type>
          <user_value_list><value>WARP</value></user_value_list></test_element>
        <test_element abstract_type="NUMERIC" real_type="double"><name>pose.z</name><type>TDI</type>
          <user_value_list><value>1</value></user_value_list></test_element>
        <test_element abstract_type="NUMERIC" real_type="double"><name>pose.path[2]</name><type>TDI</type>
          <user_value_list><value>1</value></user_value_list></test_element>
        """);
    assertThat(problems())
        .hasSize(3)
        .anyMatch(
            p ->
                p.contains(
                    "test_element mode: 'WARP' is not a literal of Mode; known literals: [SLOW,"
                        + " FAST]"))
        .anyMatch(p -> p.contains("test_element pose.z: Pose has no member 'z'; it has x, path"))
        .anyMatch(p -> p.contains("test_element pose.path[2]: Pose has no such member or element"));
  }

  @Test
  void reportsAMissingClassWithItsExpectedFolder() {
    replace("activity.yaml", "robot.Sensor", "robot.Sonar");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("component.class: no source below 'component/' declares robot.Sonar")
        .contains("expected robot/Sonar.java");
  }

  @Test
  void reportsAllProblemsOfTheProfileWithTheirLines() {
    files.put(
        "activity.yaml",
        """
        name: a b
        component:
          language: cobol
          sources: component/
          libary: x.so
          class: robot.Sensor
          execution: periodic
        provided: [missing.xml]
        models: []
        """);
    assertThat(problems())
        .anyMatch(p -> p.startsWith("activity.yaml:1: error: name: 'a b' is not a name"))
        .anyMatch(p -> p.startsWith("activity.yaml:3: error: component.language: must be java"))
        .anyMatch(p -> p.startsWith("activity.yaml:5: error: component.libary: unknown entry"))
        .anyMatch(p -> p.contains("component.period_ms: execution: periodic needs a period"))
        .anyMatch(p -> p.contains("provided: 'missing.xml' does not exist in the activity"))
        .as("models may be added later")
        .noneMatch(p -> p.contains("models"));
  }

  @Test
  void componentAndReferenceDoNotSeeEachOthersFiles() {
    replace(
        "activity.yaml",
        "provided:",
        "reference: {language: python, sources: other, class: other.Sensor}\nprovided:");
    assertThat(problems())
        .anyMatch(p -> p.contains("reference.sources: the activity has no file below 'other'"));
    files.put("other/other.py", "class Sensor: pass");
    Activity activity = read();
    assertThat(activity.withoutReferenceFiles().files().paths())
        .doesNotContain("other/other.py")
        .contains("component/robot/Sensor.java", "activity.yaml", "world/ir.world.yaml");
    assertThat(activity.ofReference().files().paths())
        .contains("other/other.py", "service.xml")
        .doesNotContain("component/robot/Sensor.java");
    assertThat(activity.ofReference().profile().harness()).isEqualTo(Language.PYTHON);
  }

  @Test
  void sanitizersAreOnlyForComponentsInCpp() {
    replace("activity.yaml", "provided:", "sanitize: [address, thread, leak]\nprovided:");
    assertThat(problems())
        .anyMatch(
            p -> p.contains("sanitize: must list address, undefined and thread only, not 'leak'"))
        .anyMatch(p -> p.contains("sanitize: cannot list both address and thread"))
        .anyMatch(p -> p.contains("sanitize: is only allowed for components in C++; remove it"));
  }

  @Test
  void theModelsTimingReplacesThatOfTheActivity() {
    replace("activity.yaml", "provided:", "timing: {repeat: 30}\nprovided:");
    Activity activity = read();
    assertThat(activity.profile().timing()).isEqualTo(new Timing(3, 30, 6));
    TestModel model = activity.model("GetInfraredData").orElseThrow();
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    assertThat(new TestApplication(activity, model, suite, activity.files(), "x").timing())
        .isEqualTo(new Timing(3, 30, 6));
    replace("GetInfraredData.xml", "</test_model>", "<timing warm_up=\"0\"/></test_model>");
    TestModel own = read().model("GetInfraredData").orElseThrow();
    Timing timing = new TestApplication(activity, own, suite, activity.files(), "x").timing();
    assertThat(timing.warmUp()).isZero();
    assertThat(timing.repeat()).isEqualTo(20);
  }

  @Test
  void timingsOutOfRangeAreReportedTogether() {
    replace(
        "activity.yaml",
        "provided:",
        "timing: {warm_up: 1001, repeat: 2.5, repeats: 3}\nprovided:");
    replace(
        "GetInfraredData.xml", "</test_model>", "<timing repeat=\"0\" warmup=\"1\"/></test_model>");
    assertThat(problems())
        .anyMatch(
            p ->
                p.startsWith(
                    "activity.yaml:6: error: timing.warm_up: must be a whole number from 0"))
        .anyMatch(p -> p.contains("timing.repeat: must be a whole number from 1 to 10000"))
        .anyMatch(p -> p.contains("timing.repeats: unknown entry"))
        .anyMatch(p -> p.contains("timing: repeat must be a whole number from 1 to 10000, not 0"))
        .anyMatch(p -> p.contains("warmup"));
  }

  @Test
  void timingNeedsAComponentPerCase() {
    replace("activity.yaml", "provided:", "  life_cycle: suite\ntiming: {}\nprovided:");
    assertThat(problems())
        .anyMatch(p -> p.startsWith("activity.yaml:7: error: timing: needs life_cycle: case, "));
    replace("activity.yaml", "timing: {}\n", "");
    replace("GetInfraredData.xml", "</test_model>", "<timing/></test_model>");
    assertThat(problems())
        .anyMatch(p -> p.contains("write life_cycle: case, or remove timing"))
        .allMatch(p -> p.matches(".*GetInfraredData.xml:[1-9].*"));
  }

  @Test
  void rejectsAYamlBomb() {
    StringBuilder bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
    for (int i = 1; i < 30; i++) {
      String of = "*a" + (i - 1);
      bomb.append("a%d: &a%d [%s, %s, %s, %s, %s]\n".formatted(i, i, of, of, of, of, of));
    }
    files.put("activity.yaml", bomb.toString());
    assertThatThrownBy(this::read).isInstanceOf(InvalidInputException.class);
  }

  @Test
  void readsAWrittenZipUnchanged() throws IOException {
    FileTree tree = read().files();
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    ActivityArchive.write(tree, zip);
    assertThat(ActivityArchive.read(new ByteArrayInputStream(zip.toByteArray()), "a.zip"))
        .isEqualTo(tree);
    ByteArrayOutputStream again = new ByteArrayOutputStream();
    ActivityArchive.write(tree, again);
    assertThat(again.toByteArray()).isEqualTo(zip.toByteArray());
  }

  @Test
  void rejectsAZipThatLeavesItsFolder() throws IOException {
    for (String path : List.of("../evil", "/etc/passwd", "a/../../b", "a\\..\\b")) {
      ByteArrayOutputStream zip = new ByteArrayOutputStream();
      try (ZipOutputStream out = new ZipOutputStream(zip)) {
        out.putNextEntry(new ZipEntry(path));
        out.write(1);
      }
      assertThatThrownBy(
              () -> ActivityArchive.read(new ByteArrayInputStream(zip.toByteArray()), "a.zip"))
          .isInstanceOf(InvalidInputException.class)
          .hasMessageContaining("is rejected");
    }
  }

  @Test
  void reportsAFileThatIsNotAZip() {
    assertThatThrownBy(
            () ->
                ActivityArchive.read(
                    new ByteArrayInputStream("hello".getBytes(StandardCharsets.UTF_8)), "a.zip"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessage("a.zip: error: is not a ZIP archive or contains no file");
  }
}
