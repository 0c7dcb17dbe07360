package org.sitaf.cli.describe;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.cli.Sitaf;

class DescribeCommandTest {
  private static final Path FIXTURES = Path.of("src/test/resources/org/sitaf/cli/describe");

  private record Run(int exitCode, String out, String err) {}

  private static Run describe(Path... files) {
    return run(Stream.of(files).map(Path::toString).toList());
  }

  private static Run run(List<String> words) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    String[] arguments =
        Stream.concat(Stream.of("describe"), words.stream()).toArray(String[]::new);
    int exitCode =
        Sitaf.commandLine()
            .setOut(new PrintWriter(out))
            .setErr(new PrintWriter(err))
            .execute(arguments);
    return new Run(exitCode, out.toString(), err.toString());
  }

  @ParameterizedTest
  @CsvSource({"opros,2", "idl,0", "ros,0", "proto,0"})
  void describesAFolderOfEachKind(String kind, int exitCode) throws IOException {
    Run run = describe(FIXTURES.resolve(kind));
    String text = (run.out() + run.err()).replace(FIXTURES + "/", "").replace("\r", "");
    assertThat(text).isEqualTo(Files.readString(FIXTURES.resolve(kind + ".txt")));
    assertThat(run.exitCode()).isEqualTo(exitCode);
  }

  @Test
  void aSingleProfileFindsTheFilesNextToIt() {
    Run run = describe(FIXTURES.resolve("opros/GripperComp.xml"));
    assertThat(run.out())
        .contains("interface GripperService  (provided by GripperComp)")
        .contains("data out   gripperState : GripperState")
        .contains("FingerState[2]  fingers");
    assertThat(run.err()).contains("GripperComp.xml:33: error: service_port ServoService");
    assertThat(run.exitCode()).isEqualTo(2);
  }

  @Test
  void aSingleRosServiceFindsMessagesOfItsPackage() {
    Run run = describe(FIXTURES.resolve("ros/arm_msgs/srv/SetLimits.srv"));
    assertThat(run.out())
        .contains("interface arm_msgs")
        .contains("sequence<arm_msgs/JointLimits,7> limits")
        .contains("struct arm_msgs/JointLimits");
  }

  @Test
  void describesAnArchiveLikeAFolder(@TempDir Path folder) throws IOException {
    Path archive = folder.resolve("gripper.zip");
    try (OutputStream file = Files.newOutputStream(archive);
        ZipOutputStream zip = new ZipOutputStream(file)) {
      for (String name : List.of("GripperComp.xml", "GripperService.xml", "GripperTypes.xml")) {
        zip.putNextEntry(new ZipEntry("profiles/" + name));
        zip.write(Files.readAllBytes(FIXTURES.resolve("opros").resolve(name)));
        zip.closeEntry();
      }
    }
    Run zipped = describe(archive);
    Run plain = describe(FIXTURES.resolve("opros"));
    assertThat(zipped.out().replace(archive + "/", ""))
        .isEqualTo(plain.out().replace(FIXTURES.resolve("opros") + "/", ""));
  }

  @Test
  void exitsWithTwoForMissingOrInvalidFiles(@TempDir Path folder) throws IOException {
    Run missing = describe(folder.resolve("none.idl"));
    assertThat(missing.exitCode()).isEqualTo(2);
    assertThat(missing.err()).contains("none.idl: error: does not exist");
    Run empty = describe(folder);
    assertThat(empty.exitCode()).isEqualTo(2);
    assertThat(empty.err()).contains("contains no interface file");
    Path text = Files.writeString(folder.resolve("notes.txt"), "interface?");
    assertThat(describe(text).err()).contains("notes.txt: error: is not an interface file");
  }

  @Test
  void escapesControlCharacters(@TempDir Path folder) throws IOException {
    Path file =
        Files.writeString(folder.resolve("a.idl"), "interface A { void f(in \u001b[31mred x); };");
    Run run = describe(file);
    assertThat(run.out() + run.err()).doesNotContain("\u001b").contains("\\u001b");
  }

  @Test
  void searchesIncludedIdlFilesInTheGivenFolders(@TempDir Path folder) throws IOException {
    Path include = Files.createDirectories(folder.resolve("include/robot"));
    Files.writeString(include.resolve("types.idl"), "#define REAL double\nstruct P { REAL x; };");
    Files.writeString(include.resolve("broken.idl"), "struct {");
    Path file =
        Files.writeString(
            Files.createDirectories(folder.resolve("idl")).resolve("a.idl"),
            "#include <robot/types.idl>\ninterface A { P get(in REAL t); };");
    assertThat(describe(file).err()).contains("'robot/types.idl' was not found; add its folder");
    Run found = run(List.of("-I", folder.resolve("include").toString(), file.toString()));
    assertThat(found.out()).contains("interface A").contains("struct P");
    assertThat(found.err()).isEmpty();
    assertThat(found.exitCode()).isZero();
    assertThat(run(List.of("-I", file.toString(), file.toString())).err())
        .contains("a.idl: error: is not a folder; -I needs one");
  }

  @Test
  void importsRealProfilesOrReportsMissingReferences() throws IOException {
    Path profiles = Path.of("../../../shared/opros-profiles");
    Assumptions.assumeTrue(Files.isDirectory(profiles), "needs ../shared next to the source tree");
    Run run = describe(profiles);
    assertThat(run.out())
        .contains("component InfraredSensorComp 1.0")
        .contains("execution  periodic, every 100 ms")
        .contains("interface MessagePrint  (provided by MessagePrinter; required by HelloMaker)")
        .contains("data in    UserDataIn : UserDataType")
        .contains("struct UserDataType");
    List<String> errors =
        run.err()
            .lines()
            .filter(l -> l.contains(": error: "))
            .map(l -> l.toLowerCase(Locale.ROOT))
            .toList();
    // Two profiles refer to files that were not published.
    assertThat(errors)
        .hasSize(8)
        .allMatch(
            l ->
                l.matches(
                    ".*kitech_\\w+comp\\.xml:[1-9][0-9]*: error: service_port .* references '.*"));
    assertThat(run.exitCode()).isEqualTo(2);
  }
}
