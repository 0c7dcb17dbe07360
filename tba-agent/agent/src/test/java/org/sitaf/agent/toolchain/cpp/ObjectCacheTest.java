package org.sitaf.agent.toolchain.cpp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.compiler.TestApplicationCompiler;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;

/**
 * Changed units are compiled again, unchanged ones are not, and users never get others' objects.
 */
@Tag("slow")
@Timeout(300)
class ObjectCacheTest {
  private static final String MAIN = "activity/component/main.cpp";
  private static final String OTHER = "activity/component/other.cpp";

  @TempDir private Path directory;

  private final Map<String, String> files = new HashMap<>();
  private Toolchain toolchain;

  @BeforeEach
  void setUpAgent() throws IOException {
    Path runtimes = Path.of(System.getProperty("sitaf.runtimes"));
    Path cache = directory.resolve("cache");
    Path compiled = runtimes.resolveSibling("test-cache").resolve("cpp/runtime");
    Files.createDirectories(cache.resolve("cpp"));
    Files.createSymbolicLink(cache.resolve("cpp/runtime"), Files.createDirectories(compiled));
    Toolchains toolchains = new Toolchains(new ToolchainPlaces(runtimes, cache));
    assumeTrue(
        toolchains.of(Language.CPP).isPresent(),
        () -> "skipped: " + toolchains.missingMessage(Language.CPP));
    toolchain = toolchains.of(Language.CPP).orElseThrow();
    component("value();\n#include \"other.hpp\"\n");
    put("other.hpp", "int value();\n");
    put("other.cpp", "#include \"other.hpp\"\nint value() { return 1; }\n");
  }

  /** A component with the given return value, which may be followed by directives. */
  private void component(String expression) {
    put("main.cpp", "#include \"other.hpp\"\nint component() { return " + expression + "}\n");
  }

  private void put(String path, String text) {
    files.put("component/" + path, text);
  }

  /**
   * The result of a build.
   *
   * @param value the return value of the component
   * @param compiled units that were compiled, not taken from the cache
   */
  private record Built(int value, Set<String> compiled) {}

  private TestApplication application() {
    EchoActivity activity = EchoActivity.inCpp("Component");
    files.forEach(activity::file);
    TestApplication scripted = activity.application();
    return new TestApplication(
        scripted.activity(),
        scripted.model(),
        scripted.suite(),
        FileTree.of(
            Map.of(
                "program/main.cpp",
                "int component(); int main() { return component(); }"
                    .getBytes(StandardCharsets.UTF_8))),
        "program");
  }

  private Built build() throws Exception {
    return build(false);
  }

  private Built build(boolean coverage) throws Exception {
    Path build = Files.createTempDirectory(directory, "build");
    TestApplication application = application();
    FileTree layout = application.files();
    for (String path : layout.paths()) {
      Path file = build.resolve("application").resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, layout.content(path).orElseThrow());
    }
    TestApplicationCompiler compiler =
        new TestApplicationCompiler(
            toolchain, directory.resolve("cache/compiled"), coverage, SandboxMode.AUTO.open());
    Compilation compilation = compiler.begin(application, build.resolve("application"), build);
    CompiledApplication compiled = compiler.compile(compilation);
    return new Built(run(compiled, build), units(compilation));
  }

  private static int run(CompiledApplication compiled, Path build) throws Exception {
    ProcessPlace place = new ProcessPlace(build, null, 128, 0);
    ProcessBuilder program = new ProcessBuilder(compiled.command(place));
    program.environment().putAll(compiled.environment(place));
    program.directory(build.toFile());
    Process process = program.start();
    assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
    return process.exitValue();
  }

  /** The dependency file as each compiler writes it. */
  private static Set<String> units(Compilation compilation) throws IOException {
    Set<String> units = new TreeSet<>();
    try (Stream<Path> all = Files.walk(compilation.scratch())) {
      for (Path file : all.filter(f -> f.toString().matches(".*/unit\\d+\\.d")).toList()) {
        String[] words = Files.readString(file).split("[\\s\\\\]+", 3);
        units.add(compilation.sources().relativize(Path.of(words[1])).toString());
      }
    }
    return units;
  }

  @Test
  void reportsAMissingDefinitionAsALinkerError() {
    put("main.cpp", "int component();\n");

    assertThatThrownBy(this::build)
        .isInstanceOf(CompilationException.class)
        .hasMessageStartingWith("the test application cannot be linked: 1 error; ")
        .hasMessageContaining("undefined reference to");
  }

  @Test
  void doesNotRecompileAnUnchangedUnit() throws Exception {
    component("value();");
    assertThat(build()).isEqualTo(new Built(1, Set.of("harness/program/main.cpp", MAIN, OTHER)));
    put("other.cpp", "#include \"other.hpp\"\nint value() { return 2; }\n");

    assertThat(build()).isEqualTo(new Built(2, Set.of(OTHER)));
    assertThat(build()).isEqualTo(new Built(2, Set.of()));
    put("other.cpp", "#include \"other.hpp\"\nint value() { return 1; }\n");
    assertThat(build()).isEqualTo(new Built(1, Set.of()));
  }

  @Test
  void doesNotRecompileAfterChangesOfDataAndComments() throws Exception {
    component("value();");
    build();
    put("README.md", "text");
    files.put("data/other.hpp", "not in the search path");
    files.put("component/deep/main.hpp", "nor here");

    assertThat(build()).isEqualTo(new Built(1, Set.of()));
  }

  @Test
  void recompilesAfterAChangedIncludedSource() throws Exception {
    component("part();}\n#include \"part.cc\"\nint nothing() { return 0;");
    put("other.hpp", "int part();\n");
    put("other.cpp", "");
    put(
        "part.cc",
        "#ifndef PART\n#define PART\nstatic int part_value() { return 0; }\n"
            + "__attribute__((weak)) int part() { return part_value(); }\n#endif\n");
    assertThat(build().value()).isZero();
    put("part.cc", files.get("component/part.cc").replace("return 0", "return 100"));

    assertThat(build()).isEqualTo(new Built(100, Set.of(MAIN, "activity/component/part.cc")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"shared/x.hpp", "world/x.hpp", "shared/a b$c#d/x.hpp"})
  void aHeaderOutsideOfTheSourcesCounts(String path) throws Exception {
    files.put(
        "component/main.cpp", "#include \"../" + path + "\"\nint component() { return X; }\n");
    files.put(path, "#define X 0\n");
    assertThat(build().value()).isZero();
    files.put(path, "#define X 100\n");

    assertThat(build()).isEqualTo(new Built(100, Set.of(MAIN)));
  }

  @Test
  void detectsANewHeaderEarlierInTheSearchPath() throws Exception {
    put("main.cpp", "#include \"sub/middle.hpp\"\nint component() { return X; }\n");
    put("sub/middle.hpp", "#include \"x.hpp\"\n");
    put("x.hpp", "#define X 1\n");
    assertThat(build().value()).isEqualTo(1);
    put("sub/x.hpp", "#define X 2\n");

    assertThat(build()).isEqualTo(new Built(2, Set.of(MAIN)));
  }

  @Test
  void countsFilesIncludedByTheAssembler() throws Exception {
    put(
        "main.cpp",
        "asm(\".data\\n.global blob\\nblob: .incbin \\\"blob.bin\\\"\\n.text\");\n"
            + "extern \"C\" unsigned char blob[];\nint component() { return blob[0] - '0'; }\n");
    put("blob.bin", "1");
    assertThat(build().value()).isEqualTo(1);
    assertThat(build().compiled()).isEmpty();
    put("blob.bin", "2");

    assertThat(build()).isEqualTo(new Built(2, Set.of(MAIN)));
  }

  @Test
  void doesNotCacheObjectsWithUnknownInputs() throws Exception {
    put(
        "main.cpp",
        "asm(\".section .note.x\\n.incbin \\\"/etc/passwd\\\"\\n.text\");\n"
            + "int component() { return 1; }\n");

    assertThat(build().compiled()).contains(MAIN);
    assertThat(build().compiled()).containsExactly(MAIN);
  }

  @Test
  void dateAndFileTimesAreReproducible() throws Exception {
    put(
        "main.cpp",
        "static const char* times = __DATE__ __TIME__ __TIMESTAMP__ __FILE__;\n"
            + "int component() { int sum = 0; for (const char* c = times; *c; c++) sum = sum * 31 +"
            + " *c; return sum & 127; }\n");
    int first = build().value();
    for (Path cached :
        List.of(directory.resolve("cache/compiled"), directory.resolve("cache/cpp/objects"))) {
      Folders.delete(cached);
    }
    Thread.sleep(1100);

    assertThat(build())
        .isEqualTo(new Built(first, Set.of("harness/program/main.cpp", MAIN, OTHER)));
  }

  @Test
  void usersDoNotGetObjectsOfOtherUsers() throws Exception {
    files.put("component/main.cpp", "#include \"../mine/x.hpp\"\nint component() { return X; }\n");
    files.put("mine/x.hpp", "#define X 1\n");
    assertThat(build().value()).isEqualTo(1);
    files.put("mine/x.hpp", "#define X 100\n");
    assertThat(build().value()).isEqualTo(100);
    files.put("mine/x.hpp", "#define X 1\n");

    // Except the object that was compiled from equal inputs.
    assertThat(build()).isEqualTo(new Built(1, Set.of()));
  }

  /** The list of warnings is empty. */
  private static boolean hasContent(Path file) {
    return file.toFile().isFile() && file.toFile().length() > 0;
  }

  @Test
  void doesNotUseAModifiedEntry() throws Exception {
    component("value();");
    build();
    Path objects = directory.resolve("cache/cpp/objects");
    for (Path folder : List.of(objects, directory.resolve("cache/compiled"))) {
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path file : all.filter(ObjectCacheTest::hasContent).toList()) {
          byte[] content = Files.readAllBytes(file);
          content[Math.max(0, content.length - 40)] ^= 1;
          Files.write(file, content);
        }
      }
    }

    assertThat(build()).isEqualTo(new Built(1, Set.of("harness/program/main.cpp", MAIN, OTHER)));
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(objects)))
        .isEqualTo("rwx------");
  }

  @Test
  void cachesCoverageNotesWithTheirObjects() throws Exception {
    component("value();");
    assertThat(build(true).value()).isEqualTo(1);
    put("other.cpp", "#include \"other.hpp\"\nint value() { return 2; }\n");

    assertThat(build(true)).isEqualTo(new Built(2, Set.of(OTHER)));
    assertThat(build(false).compiled()).contains(MAIN, OTHER);
  }
}
