package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/** Compares the sources of the paper's example with golden files. */
class GoldenHarnessTest {
  private static final Path EXAMPLE = Path.of("../../examples/ir-sensor");
  private static final Path GOLDEN =
      Path.of("src/test/resources/org/sitaf/core/harness/java/ir-sensor");
  private static final String FOLDER = "sitaf/harness/getinfrareddata/";
  private static final boolean UPDATE_GOLDEN = Boolean.getBoolean("sitaf.golden.update");

  @TempDir Path folder;

  private static TestApplication generate(FileTree files) {
    Activity activity = Activity.read(files);
    var model = activity.models().get(0);
    return InterfaceTestApplicationGenerator.generate(
        activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
  }

  @Test
  void generatesTheGoldenSources() throws IOException {
    FileTree harness = generate(HarnessBuild.tree(EXAMPLE)).harness();
    assertThat(harness.paths())
        .containsExactly(
            FOLDER + "ConcreteTestDriver.java",
            FOLDER + "SimulationControl.java",
            FOLDER + "TestDriver.java",
            FOLDER + "TestStub.java");
    for (String path : harness.paths()) {
      Path golden = GOLDEN.resolve(path.substring(FOLDER.length()));
      if (UPDATE_GOLDEN) {
        Files.createDirectories(GOLDEN);
        Files.write(golden, harness.content(path).orElseThrow());
      }
      assertThat(harness.text(path))
          .as(
              "%s (after an intended change: run this test with -Dsitaf.golden.update=true, and"
                  + " review the diff)",
              path)
          .contains(Files.readString(golden));
    }
  }

  @Test
  void theFiveStepsAreInOrder() throws IOException {
    String driver =
        generate(HarnessBuild.tree(EXAMPLE))
            .harness()
            .text(FOLDER + "TestDriver.java")
            .orElseThrow();
    assertThat(
            driver
                .lines()
                .map(String::strip)
                .filter(l -> l.matches("// \\d\\..*|.*(prepare|start|stop|save|call)\\(.*;")))
        .containsExactly(
            "// 1. Read the test case.",
            "// 2. The simulation control sets up the virtual environment (TDSD).",
            "simulationControl.prepare(distance);",
            "// 3. The test stub gets the answers of the required interfaces (TDTS).",
            "testStub.prepare();",
            "// 4. The component is called with the input (TDI). The call is timed.",
            "stopwatch.start();",
            "double returned = call(component, indexOfSensor, numOfSensor);",
            "stopwatch.stop();",
            "// 5. The outputs are recorded and saved.",
            "save(result);");
  }

  @Test
  void generatedSourcesCompileWithoutWarnings() throws IOException {
    new HarnessBuild(folder).compile(generate(HarnessBuild.tree(EXAMPLE)));
  }

  @Test
  void usesTheDriverOfTheUserUnchanged() throws IOException {
    String customDriver = "package sitaf.harness.getinfrareddata; // mine\n";
    FileTree files =
        HarnessBuild.tree(EXAMPLE)
            .with(
                "harness/GetInfraredData",
                HarnessBuild.tree(Map.of("ConcreteTestDriver.java", customDriver)));
    TestApplication application = generate(files);
    assertThat(application.harness().text(FOLDER + "ConcreteTestDriver.java"))
        .contains(customDriver);
    assertThat(application.entryPoint())
        .isEqualTo("sitaf.harness.getinfrareddata.ConcreteTestDriver");
  }

  @Test
  void readsAnApplicationFromItsFiles() throws IOException {
    TestApplication application = generate(HarnessBuild.tree(EXAMPLE));
    TestApplication again = TestApplication.read(application.files());
    assertThat(again.files()).isEqualTo(application.files());
  }
}
