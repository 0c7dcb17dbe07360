package org.sitaf.core.beginning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.choice.InterfaceChoice;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

class NewActivityTest {
  private static final FileTree NONE = FileTree.of(Map.of());
  private static final String ARM =
      """
      enum Mode { SLOW, FAST };
      struct Point { double x; double y; double z; };
      struct Quaternion { double x; double y; double z; double w; };
      struct Pose { Point position; Quaternion orientation; };
      typedef sequence<Point> Points;
      interface Arm {
        boolean Move(in Pose target, in Mode mode, in double max_speed, out string reason);
        void Turn(in double angle, in double angle_deg, in octet joint_id, in Points path);
        void Say(in string text, in any what);
        void Stop();
      };
      """;

  private static FileTree propose(Language language, String idl) {
    return proposal(language, "arm", null, idl).files();
  }

  private static Proposal proposal(
      Language language, String name, @Nullable String className, String idl) {
    byte[] content = idl.getBytes(StandardCharsets.UTF_8);
    var read =
        InterfaceFiles.read(SourceFiles.of("a", Map.of("Arm.idl", content), List.of("Arm.idl")));
    return new NewActivity(
            name,
            language,
            className,
            List.of("Arm.idl"),
            read.provided(),
            FileTree.of(Map.of("Arm.idl", content)),
            NONE,
            null)
        .propose();
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void isAnActivityWithoutProblemsWhoseModelsHaveCases(Language language) {
    FileTree files = propose(language, ARM);

    Activity activity = Activity.read(files);

    assertThat(activity.models())
        .extracting(TestModel::name)
        .containsExactly("Move", "Stop", "Turn");
    for (TestModel model : activity.models()) {
      var suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
      assertThat(suite.cases()).isNotEmpty().hasSizeLessThanOrEqualTo(150);
    }
  }

  @Test
  void takesWholePosesLiteralsAndRangesThatNamesTell() {
    FileTree files = propose(Language.PYTHON, ARM);

    assertThat(files.text("Move.xml").orElseThrow())
        .contains("<test_spec type=\"POSE\"", "<value>SLOW</value>", "<value>FAST</value>");
    assertThat(files.text("Turn.xml").orElseThrow())
        .contains("min=\"-3.141592653589793\"", "min=\"-180\"", "<value>[]</value>")
        .contains("<value>[{x: 0.0, y: 0.0, z: 0.0}]</value>");
  }

  @Test
  void refusesWhatTheLanguageCannotExpress() {
    String idl = "interface Sensor { boolean del(in double range); };";

    assertThatThrownBy(() -> propose(Language.PYTHON, idl))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("is not a valid Python method name");
    assertThat(propose(Language.JAVA, idl).contains("del.xml")).isTrue();
  }

  @Test
  void aMethodMayHaveTheNameOfItsInterface() {
    String idl = "interface move { boolean move(in double speed); };";

    assertThat(propose(Language.CPP, idl).contains("move.xml")).isTrue();
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void renamesTypesAndMembersThatTheLanguageDoesNotAllow(Language language) {
    String idl =
        "struct Duration { double from; long class; };"
            + " interface Sensor { boolean Set(in Duration range); };";

    assertThat(propose(language, idl).text("Set.xml").orElseThrow())
        .contains("range.from", "range.class");
  }

  @Test
  void leavesOutMethodsWithUnknownTypes() {
    assertThat(propose(Language.PYTHON, ARM).paths()).doesNotContain("Say.xml");
  }

  @Test
  void notesNameTheMethodsThatAreLeftOut() {
    assertThat(proposal(Language.PYTHON, "arm", null, ARM).notes())
        .containsExactly(
            "Say of Arm is left out, because a type of it is not defined; add the file that defines"
                + " it");
  }

  @Test
  void aModelDoesNotReplaceAnInterfaceOfItsName() {
    String profile =
        """
        <service_port_type_profile><service_port_type><type_name>Arm</type_name>
        <method name="Move" return_type="int" call_type="blocking"/>
        </service_port_type></service_port_type_profile>
        """;
    FileTree files = FileTree.of(Map.of("Move.xml", profile.getBytes(StandardCharsets.UTF_8)));
    InterfaceChoice chosen = InterfaceChoice.of("Move.xml", files, NONE);

    FileTree proposed =
        new NewActivity(
                "arm",
                Language.JAVA,
                null,
                List.of(chosen.path()),
                chosen.provided(),
                chosen.files(),
                NONE,
                null)
            .propose()
            .files();

    assertThat(proposed.text("Move.xml")).contains(profile);
    assertThat(proposed.contains("Arm_Move.xml")).isTrue();
  }

  @ParameterizedTest
  @CsvSource({
    "JAVA, 'a.B\nworld: x'",
    "JAVA, '1a.B'",
    "PYTHON, 'a b.C'",
    "PYTHON, C",
    "CPP, 'a::B {'",
    "CPP, 'a.B'"
  })
  void refusesAClassOfAnotherForm(Language language, String className) {
    assertThatThrownBy(() -> proposal(language, "arm", className, ARM))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("component.class");
  }

  @Test
  void refusesANameThatActivitiesCannotHave() {
    assertThatThrownBy(() -> proposal(Language.JAVA, "a: b\nworld: x", null, ARM))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("activity.yaml:1: error: name:");
  }

  /** The value of one parameter would fill the memory. */
  @Test
  void refusesTypesWhoseValuesAreTooLong() {
    String idl =
        "typedef double Row[1000]; typedef Row Table[1000]; interface Big { void f(in Table all);"
            + " };";
    assertThatThrownBy(() -> proposal(Language.JAVA, "big", null, idl))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("a type has no value of less than 100000 characters");
  }

  @Test
  void refusesAnInterfaceWithoutMethods() {
    assertThatThrownBy(() -> propose(Language.JAVA, "struct Point { double x; };"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("contains no interface with a method");
  }

  @ParameterizedTest
  @CsvSource({
    "yaw, DOUBLE, -3.141592653589793, 3.141592653589793",
    "goal_heading_deg, DOUBLE, -180, 180",
    "probability, FLOAT, 0, 1",
    "time_allowance, DOUBLE, 0, 10",
    "timeoutMs, INT32, 0, 1000",
    "robot_id, UINT8, 0, 10",
    "brightness, UINT8, 0, 255",
    "latitude, DOUBLE, -90, 90",
    "nanosec, UINT32, 0, 999999999",
    "anything, DOUBLE, -1, 1"
  })
  void guessesRangesFromNamesAndTypes(String name, ScalarType type, String min, String max) {
    NumberRange range = NumberRange.of(name, type);

    assertThat(range.min()).isEqualTo(min);
    assertThat(range.max()).isEqualTo(max);
  }
}
