package org.sitaf.core.harness.cpp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/** Compares C++ sources of examples with golden files. */
class GoldenHarnessTest {
  private static final Path RESOURCES = Path.of("src/test/resources/org/sitaf/core/harness/cpp");
  private static final boolean UPDATE_GOLDEN = Boolean.getBoolean("sitaf.golden.update");

  static TestApplication generate(FileTree files) {
    Activity activity = Activity.read(files);
    var model = activity.models().get(0);
    return InterfaceTestApplicationGenerator.generate(
        activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
  }

  static FileTree tree(Path folder) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    try (var walk = Files.walk(folder)) {
      for (Path file : walk.filter(Files::isRegularFile).toList()) {
        files.put(folder.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return FileTree.of(files);
  }

  /**
   * The paper's example, and one with the features that it does not use: stubs, structs,
   * enumerations, members, errors, a period, observed outputs.
   */
  @ParameterizedTest
  @ValueSource(strings = {"ir-sensor", "wide"})
  void generatesTheGoldenSources(String name) throws IOException {
    Path activity =
        name.equals("wide")
            ? RESOURCES.resolve("wide-activity")
            : Path.of("../../examples/ir-sensor-cpp");
    FileTree harness = generate(tree(activity)).harness();
    Path golden = RESOURCES.resolve(name);
    if (UPDATE_GOLDEN) {
      for (String path : harness.paths()) {
        Files.createDirectories(golden.resolve(path).getParent());
        Files.write(golden.resolve(path), harness.content(path).orElseThrow());
      }
    }
    assertThat(harness.paths()).containsExactlyInAnyOrderElementsOf(tree(golden).paths());
    for (String path : harness.paths()) {
      assertThat(harness.text(path))
          .as(
              "%s (after an intended change: run this test with -Dsitaf.golden.update=true, and"
                  + " review the diff)",
              path)
          .contains(Files.readString(golden.resolve(path)));
    }
  }

  @Test
  void theFiveStepsAreInOrder() throws IOException {
    String driver =
        generate(tree(Path.of("../../examples/ir-sensor-cpp")))
            .harness()
            .text("getinfrareddata/TestDriver.cpp")
            .orElseThrow();
    assertThat(
            driver
                .lines()
                .map(String::strip)
                .filter(l -> l.matches("// \\d\\..*|.*(prepare|start|stop|save|call)\\(.*;")))
        .containsExactly(
            "// 1. Read the test case.",
            "// 2. The simulation control sets up the virtual environment (TDSD).",
            "simulationControl_.prepare(distance);",
            "// 3. The test stub gets the answers of the required interfaces (TDTS).",
            "testStub_.prepare();",
            "// 4. The component is called with the input (TDI). The call is timed.",
            "stopwatch().start();",
            "const double returned = call(component, indexOfSensor, numOfSensor);",
            "stopwatch().stop();",
            "// 5. The outputs are recorded and saved.",
            "save(result);");
  }

  @Test
  void usesTheDriverOfTheUserUnchanged() throws IOException {
    FileTree files =
        tree(Path.of("../../examples/ir-sensor-cpp"))
            .with(
                "harness/GetInfraredData/ConcreteTestDriver.cpp",
                "// mine\n".getBytes(java.nio.charset.StandardCharsets.UTF_8));
    assertThat(generate(files).harness().text("getinfrareddata/ConcreteTestDriver.cpp"))
        .contains("// mine\n");
  }
}
