package org.sitaf.agent.toolchain.cpp.inputs;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.FileTree;

/** Detects changes of a compiler's inputs. */
class InputCheckTest {
  private static final long LATER = System.currentTimeMillis() + 3_600_000;

  @TempDir private Path directory;

  private final Map<String, byte[]> activity = new HashMap<>();

  private InputCheck check() {
    return new InputCheck(
        FileTree.of(Map.of()),
        FileTree.of(activity),
        Path.of("/build"),
        List.of(
            Path.of("/build/activity/adapter"),
            Path.of("/build/activity/component"),
            Path.of("/build/activity/include"),
            Path.of("/usr/include")),
        List.of());
  }

  private void put(String path, String text) {
    activity.put(path, text.getBytes(UTF_8));
  }

  private Inputs read(String... printed) throws Exception {
    Inputs inputs = check().of(List.of(printed), List.of(), true, LATER).orElseThrow();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    inputs.write(new DataOutputStream(bytes));
    return Inputs.read(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())));
  }

  private Inputs ofAComponent() throws Exception {
    put("component/a.cpp", "#include \"x.hpp\"\n");
    put("include/x.hpp", "1");
    return read("/build/activity/component/a.cpp", "/build/activity/include/x.hpp");
  }

  @Test
  void isCurrentIfInputsAreUnchanged() throws Exception {
    Inputs inputs = ofAComponent();
    put("include/y.hpp", "2");
    put("component/sub/x.hpp", "2");
    put("docs/x.hpp", "2");

    assertThat(check().isCurrent(inputs)).isTrue();
  }

  @Test
  void recompilesAfterAChangedHeader() throws Exception {
    Inputs inputs = ofAComponent();
    put("include/x.hpp", "2");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"adapter/x.hpp", "component/x.hpp"})
  void aHeaderThatComesInFrontIsSeen(String path) throws Exception {
    Inputs inputs = ofAComponent();
    put(path, "1");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @Test
  void ignoresANewHeaderLaterInTheSearchPath() throws Exception {
    put("component/a.cpp", "#include \"x.hpp\"\n");
    put("component/x.hpp", "1");
    Inputs inputs = read("/build/activity/component/a.cpp", "/build/activity/component/x.hpp");
    put("include/x.hpp", "2");
    put("adapter/x.hpp", "2");

    assertThat(check().isCurrent(inputs)).isTrue();
  }

  @Test
  void recompilesIfAMissingHeaderAppears() throws Exception {
    put("component/a.cpp", "#if __has_include(\"x.hpp\")\n#endif\n");
    Inputs inputs = read("/build/activity/component/a.cpp");
    put("include/x.hpp", "1");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @Test
  void recompilesIfANewHeaderHidesOneNamedByAMacro() throws Exception {
    put("component/a.cpp", "#define X \"x.hpp\"\n#include X\n");
    put("include/x.hpp", "1");
    Inputs inputs = read("/build/activity/component/a.cpp", "/build/activity/include/x.hpp");
    put("component/unrelated.hpp", "1");
    assertThat(check().isCurrent(inputs)).isTrue();
    put("component/x.hpp", "1");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @Test
  void recompilesIfANewHeaderHidesASystemHeader() throws Exception {
    put("component/a.cpp", "#include <features.h>\n");
    Inputs inputs = read("/build/activity/component/a.cpp", "/usr/include/features.h");
    put("include/features.h", "");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @Test
  void recompilesIfANewHeaderHidesOneIncludedBySystemHeaders() throws Exception {
    put("component/a.cpp", "#include <stdint.h>\n");
    // The compiler includes <stdc-predef.h> by this name.
    Inputs inputs =
        read(
            "/build/activity/component/a.cpp",
            "/usr/include/features.h",
            "/usr/include/stdc-predef.h");
    put("adapter/stdc-predef.h", "");

    assertThat(check().isCurrent(inputs)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/proc/self/environ",
        "/etc/passwd",
        "/dev/stdin",
        "/tmp/x.hpp",
        "/usr/../etc/passwd",
        "/build/suite.xml",
        "/build/activity/component/missing.hpp",
        "/build/activity/../../etc/passwd",
        "../application/activity/component/a.cpp",
        "x.hpp",
        "/usr/include/there-is-no-such-header.h"
      })
  void whatIsNeitherOfTheApplicationNorOfTheSystemIsUncertain(String printed) throws Exception {
    put("component/a.cpp", "");
    Optional<Inputs> inputs =
        check().of(List.of("/build/activity/component/a.cpp", printed), List.of(), true, LATER);

    assertThat(inputs).isEmpty();
  }

  @Test
  void assemblyWithoutDependencyFileIsUncertain() throws Exception {
    put("component/a.cpp", "asm(\".incbin \\\"x\\\"\");");
    List<String> read = List.of("/build/activity/component/a.cpp");

    assertThat(check().of(read, List.of(), false, LATER)).isEmpty();
    assertThat(check().of(read, List.of(), true, LATER)).isPresent();
  }

  @Test
  void comparesSystemHeadersByContent() throws Exception {
    Path header = Files.writeString(directory.resolve("x.hpp"), "1");
    Inputs inputs = InputCheck.ofMachine(List.of(header.toString()), LATER).orElseThrow();

    Files.setLastModifiedTime(header, FileTime.fromMillis(0));
    assertThat(InputCheck.isCurrentOnMachine(inputs)).isTrue();
    Files.writeString(header, "2");
    // Like an upgrade that sets the time of the package.
    Files.setLastModifiedTime(header, FileTime.fromMillis(0));
    assertThat(InputCheck.isCurrentOnMachine(inputs)).isFalse();
    Files.delete(header);
    assertThat(InputCheck.isCurrentOnMachine(inputs)).isFalse();
  }

  @Test
  void recompilesAfterANewFileInASearchedFolder() throws Exception {
    Path missing = directory.resolve("missing");
    Inputs inputs =
        InputCheck.ofLinker(List.of(), List.of(directory.toString(), missing.toString()), LATER)
            .orElseThrow();
    assertThat(InputCheck.isCurrentOnMachine(inputs)).isTrue();
    Files.createDirectory(missing);

    assertThat(InputCheck.isCurrentOnMachine(inputs)).isFalse();
  }

  @Test
  void aFileThatChangesDuringTheCompilationIsUncertain() throws Exception {
    Path header = Files.writeString(directory.resolve("x.hpp"), "1");

    assertThat(InputCheck.ofMachine(List.of(header.toString()), System.currentTimeMillis()))
        .isEmpty();
  }
}
