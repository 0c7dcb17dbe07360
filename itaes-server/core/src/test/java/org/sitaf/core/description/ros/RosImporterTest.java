package org.sitaf.core.description.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ImportResult;

class RosImporterTest {
  @Test
  void aFileOfRos1SaysSo() {
    ImportResult result =
        InterfaceText.read(Map.of("p/srv/Get.srv", "Header h\ntime t\n---\n"), "p/srv/Get.srv");
    assertThat(InterfaceText.lines(result))
        .containsExactly(
            "p/srv/Get.srv:1: warning: field h: type 'p/Header' is not supported: this is a file of ROS 1; in ROS 2,"
                + " 'Header' is 'std_msgs/Header'",
            "p/srv/Get.srv:2: warning: field t: type 'p/time' is not supported: this is a file of ROS 1; in ROS 2,"
                + " 'time' is 'builtin_interfaces/Time'");
  }

  @ParameterizedTest
  @CsvSource({
    "bool,boolean",
    "byte,uint8",
    "char,uint8",
    "float32,float",
    "float64,double",
    "int8,int8",
    "uint64,uint64",
    "string,string",
    "wstring,string",
    "string<=5,string<5>",
    "int32[],sequence<int32>",
    "int32[3],int32[3]",
    "'int32[<=4]','sequence<int32,4>'",
    "'string<=5[<=4]','sequence<string<5>,4>'",
    "P,p/P",
    "p/P,p/P",
    "p/msg/P,p/P",
    "P[2],p/P[2]"
  })
  void resolvesTypes(String ros, String resolved) {
    ImportResult result =
        InterfaceText.read(
            Map.of("p/srv/Get.srv", ros + " x\n---\n", "p/msg/P.msg", "float64 x"),
            "p/srv/Get.srv");
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly("void Get(IN " + resolved + " x)");
  }

  @Test
  void importsAPackageAsAnInterfaceWithServicesAndActionsAsMethods() {
    ImportResult result =
        InterfaceText.readAll(
            Map.of(
                "arm/package.xml", "<package><name>arm_msgs</name></package>",
                "arm/srv/One.srv", "int32 a 3 # with a default\n---\nfloat64 b",
                "arm/srv/Two.srv", "int32 id\n---\nint32 id\nstring text \"a # b\"",
                "arm/action/Move.action", "float64 to\n---\n---\nfloat64 left",
                "other/srv/None.srv", "---"));
    assertThat(result.provided())
        .extracting(InterfaceDescription::name)
        .containsExactly("arm_msgs", "other");
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly(
            "void Move(IN double to, OUT sequence<arm_msgs/Move_Feedback> feedback)",
            "double One(IN int32 a)",
            "void Two(IN int32 id, OUT int32 result_id, OUT string text)");
    assertThat(InterfaceText.lines(result)).isEmpty();
  }

  @Test
  void reportsAllProblemsWithTheirLines() {
    ImportResult result =
        InterfaceText.read(
            "srv/Bad.srv",
            """
            int32
            # a comment

            int32[-1] a
            int32 b
            int32 b
            float64<=3 c
            std_msgs/Header d
            uint8 e-f
            LIMIT=3
            int32[0] g
            """);
    assertThat(InterfaceText.lines(result))
        .containsExactlyInAnyOrder(
            "srv/Bad.srv:1: error: a line must contain a type and a name, such as 'float64 x'",
            "srv/Bad.srv:6: error: field b: is defined twice",
            "srv/Bad.srv:9: error: 'e-f' is not a name; use letters, digits and '_', not beginning"
                + " with a digit, at most 200 characters",
            "srv/Bad.srv:10: error: a line must contain a type and a name, such as 'float64 x'",
            "srv/Bad.srv: error: a .srv file has 1 lines '---', not 0",
            "srv/Bad.srv:4: error: field a: 'int32[-1]' is not a type, such as float64, string<=10,"
                + " Point[3] or geometry_msgs/Pose[<=5]",
            "srv/Bad.srv:7: error: field c: only a string can have a bound such as '<=3'",
            "srv/Bad.srv:8: warning: field d: unknown type 'std_msgs/Header'",
            "srv/Bad.srv:11: error: field g: a length or bound must be 1 to 1000000, not 0");
  }

  @Test
  void importsASingleMessageAsAStruct() {
    ImportResult result = InterfaceText.read("P.msg", "int32 LIMIT=3\nfloat64 x\nfloat64 y 1.5");
    assertThat(result.provided()).isEmpty();
    assertThat(result.types().toString()).contains("Struct[name=P").contains("name=y");
    assertThat(InterfaceText.lines(result)).isEmpty();
  }
}
