package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.YamlDocument;

class CppBuildReaderTest {
  private final Diagnostics diagnostics = new Diagnostics();

  private CppBuild read(String text, Language language) {
    return CppBuildReader.read(YamlDocument.read(text, "a.yaml", diagnostics), language);
  }

  private List<String> problems(String text) {
    read("sources: component/\n" + text, Language.CPP);
    return diagnostics.all().stream().map(Object::toString).toList();
  }

  @Test
  void readsAllEntries() {
    CppBuild build =
        read(
            """
            sources: component/
            packages: [fmt, eigen3==3.4.0]
            includes: [include/]
            defines: [NDEBUG, 'TEXT="a b"']
            standard: 20
            flags: [-O2, -Wextra, -Wno-unused, -ffast-math, -mavx2, -march=x86-64-v3, -fopenmp]
            """,
            Language.CPP);
    assertThat(diagnostics.all()).isEmpty();
    assertThat(build.packages()).containsExactly("fmt", "eigen3==3.4.0");
    assertThat(build.includes()).containsExactly("include/");
    assertThat(build.defines()).containsExactly("NDEBUG", "TEXT=\"a b\"");
    assertThat(build.standard()).isEqualTo(20);
    assertThat(build.flags()).hasSize(7);
    assertThat(read("standard: 14\nsources: c/", Language.CPP).standardOfHarness()).isEqualTo(17);
    assertThat(read("sources: c/", Language.CPP)).isEqualTo(CppBuild.DEFAULT);
  }

  @Test
  void readsTheTargetOfACmakeProject() {
    CppBuild build =
        read(
            "cmake: {project: component/, target: control::core, options: {WITH_GUI: OFF, N: 3}}",
            Language.CPP);

    assertThat(diagnostics.all()).isEmpty();
    assertThat(build.cmake())
        .isEqualTo(new CmakeTarget("control::core", Map.of("WITH_GUI", "OFF", "N", "3")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          cmake: {project: c/}                                       | target
          cmake: {project: c/, target: '-DX'}                        | no name of a target
          cmake: {project: c/, target: '$<TARGET_FILE:x>'}           | no name of a target
          cmake: {project: c/, target: core, goal: x}                | goal
          cmake: {project: c/, target: core, options: {'A B': 1}}    | variable of CMake
          {cmake: {project: c/, target: core}, flags: [-O3]}         | CMakeLists.txt
          {cmake: {project: c/, target: core}, defines: [A]}         | CMakeLists.txt
          """)
  void refusesOtherEntriesOfACmakeProject(String text, String message) {
    read(text, Language.CPP);

    assertThat(diagnostics.all()).isNotEmpty();
    assertThat(diagnostics.all().toString()).contains(message);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-fplugin=evil.so",
        "-Wl,-rpath,/tmp",
        "-Wl",
        "-Wa,x",
        "-B/tmp",
        "-specs=x",
        "-o/etc/passwd",
        "@options",
        "-include",
        "-I/root",
        "-DX",
        "-lm",
        "-std=c++20",
        "-save-temps",
        "-fdump-tree-all=/tmp/x",
        "-fprofile-use=/tmp",
        "-march=native;id",
        "-O9",
        "-O2 -B/tmp",
        "-wrapper"
      })
  void refusesOptionsThatNameFilesOrPrograms(String flag) {
    assertThat(problems("flags: ['" + flag + "']"))
        .hasSize(1)
        .allMatch(line -> line.contains("flags: '" + flag + "' is not allowed"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1X", "A B", "A(x)=1", "-D", "=1"})
  void refusesInvalidMacros(String define) {
    assertThat(problems("defines: ['" + define + "']"))
        .hasSize(1)
        .allMatch(line -> line.contains("is no macro such as NAME or NAME=VALUE"));
  }

  @Test
  void namesEntriesWithoutEffect() {
    assertThat(problems("standard: 18"))
        .anyMatch(line -> line.contains("must be 14, 17, 20 or 23"));
    read("standard: 20\nsources: c/", Language.JAVA);
    read("flags: [-O2]\nlibrary: lib.so", Language.CPP);
    assertThat(diagnostics.all().stream().map(Object::toString))
        .anyMatch(line -> line.contains("standard: is only allowed for components in C++"))
        .anyMatch(line -> line.contains("flags: has no effect on a compiled library"));
  }
}
