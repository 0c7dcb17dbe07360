package org.sitaf.core.beginning.choice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.diagnostic.InvalidInputException;

class InterfaceChoiceTest {
  private static final FileTree INSTALLED =
      tree(
          Map.of(
              "geometry_msgs/msg/Point.msg", "float64 x\n",
              "demo_srvs/srv/Move.srv", "geometry_msgs/Point goal\n---\nbool done\n"));

  private static FileTree tree(Map<String, String> files) {
    Map<String, byte[]> contents = new HashMap<>();
    files.forEach((path, text) -> contents.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return FileTree.of(contents);
  }

  @Test
  void takesTheFilesNextToItThatItNames() {
    FileTree given =
        tree(
            Map.of(
                "a/Arm.idl",
                "#include \"types.idl\"\ninterface Arm { void Move(in Point p); };",
                "a/types.idl",
                "struct Point { double x; };",
                "a/other.idl",
                "interface Other {};",
                "types.idl",
                "wrong"));

    InterfaceChoice choice = InterfaceChoice.of("a/Arm.idl", given, INSTALLED);

    assertThat(choice.path()).isEqualTo("Arm.idl");
    assertThat(choice.files().paths()).containsExactly("Arm.idl", "types.idl");
    assertThat(choice.files().text("types.idl").orElseThrow()).startsWith("struct");
    assertThat(choice.provided()).extracting(InterfaceDescription::name).containsExactly("Arm");
  }

  @Test
  void takesTheMessagesOfPackagesNextToItAndOfRos() {
    FileTree given =
        tree(
            Map.of(
                "ws/src/own_msgs/srv/Do.srv",
                "Mode mode\nbase_msgs/Number n\ngeometry_msgs/Point p\n---\nbool done\n",
                "ws/src/own_msgs/msg/Mode.msg",
                "uint8 mode\n",
                "ws/src/own_msgs/package.xml",
                "<package><name>own_msgs</name></package>",
                "ws/src/base_msgs/msg/Number.msg",
                "int32 n\n"));

    InterfaceChoice choice = InterfaceChoice.of("ws/src/own_msgs/srv/Do.srv", given, INSTALLED);

    assertThat(choice.path()).isEqualTo("own_msgs/srv/Do.srv");
    assertThat(choice.files().paths())
        .containsExactly(
            "base_msgs/msg/Number.msg",
            "geometry_msgs/msg/Point.msg",
            "own_msgs/msg/Mode.msg",
            "own_msgs/srv/Do.srv");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "own_msgs-main/", "ws/own_msgs-main/"})
  void aPackageHasTheNameInItsManifest(String folder) {
    FileTree given =
        tree(
            Map.of(
                folder + "package.xml",
                "<package><name>own_msgs</name></package>",
                folder + "srv/Do.srv",
                "Mode mode\nown_msgs/Size size\n---\nbool done\n",
                folder + "msg/Mode.msg",
                "uint8 mode\n",
                folder + "msg/Size.msg",
                "float64 size\n",
                folder + "src/node.cpp",
                ""));

    InterfaceChoice choice = InterfaceChoice.of(folder + "srv/Do.srv", given, INSTALLED);

    assertThat(choice.path()).isEqualTo("own_msgs/srv/Do.srv");
    assertThat(choice.files().paths())
        .containsExactly("own_msgs/msg/Mode.msg", "own_msgs/msg/Size.msg", "own_msgs/srv/Do.srv");
  }

  @Test
  void anInstalledInterfaceNeedsNoFiles() {
    InterfaceChoice choice =
        InterfaceChoice.of("demo_srvs/srv/Move.srv", tree(Map.of()), INSTALLED);

    assertThat(choice.path()).isEqualTo("demo_srvs/srv/Move.srv");
    assertThat(choice.files().paths()).isEmpty();
    assertThat(choice.provided().get(0).methods()).hasSize(1);
  }

  @Test
  void refusesWhatIsNoInterfaceFile() {
    FileTree given = tree(Map.of("notes.txt", "", "Arm.idl", "interface {"));
    assertThatThrownBy(() -> InterfaceChoice.of("notes.txt", given, INSTALLED))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("notes.txt: error: is not an interface file: .xml (OPRoS), .idl");
    assertThatThrownBy(() -> InterfaceChoice.of("demo_srvs/srv/Mvoe.srv", given, INSTALLED))
        .hasMessageContaining("is neither a given file nor an installed interface of ROS 2");
    assertThatThrownBy(() -> InterfaceChoice.of("Arm.idl", given, INSTALLED))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("Arm.idl");
  }

  /** A pattern that scans characters again from each position would take hours. */
  @Test
  void readsAHostileFileInOnePass() {
    FileTree words = tree(Map.of("a.idl", "interface A { void f(); }; // " + "a".repeat(2 << 20)));
    assertThat(InterfaceChoice.of("a.idl", words, INSTALLED).files().paths()).hasSize(1);
    FileTree lines = tree(Map.of("p/srv/A.srv", "\n".repeat(2 << 20) + "---\n"));
    assertThat(InterfaceChoice.of("p/srv/A.srv", lines, INSTALLED).files().paths()).hasSize(1);
  }

  @Test
  void placesAreRelativeToTheFolderAboveAPackage() {
    assertThat(InterfacePlace.of("home/ws/own_msgs/srv/Do.srv"))
        .isEqualTo(
            new InterfacePlace(
                "home/ws",
                "own_msgs/srv/Do.srv",
                List.of("own_msgs", "own_msgs/action", "own_msgs/msg", "own_msgs/srv")));
    assertThat(InterfacePlace.of("home/srv/Arm.idl").path()).isEqualTo("home/srv/Arm.idl");
    assertThat(InterfacePlace.of("home/Arm.idl"))
        .isEqualTo(new InterfacePlace("home", "Arm.idl", List.of("")));
    assertThat(InterfacePlace.of("Arm.idl"))
        .isEqualTo(new InterfacePlace("", "Arm.idl", List.of("")));
  }
}
