package org.sitaf.core.harness.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * Compares the sources of two activities with golden files: the paper's example, and one with all
 * features of interfaces. The tests of the Python runtime format, compile and run them.
 */
class GoldenPythonHarnessTest {
  private static final Path GOLDENS = Path.of("src/test/resources/org/sitaf/core/harness/python");
  private static final boolean UPDATE_GOLDEN = Boolean.getBoolean("sitaf.golden.update");

  private static Path activity(String name) {
    return name.equals("ir-sensor-python")
        ? Path.of("../../examples", name)
        : GOLDENS.resolve(name).resolve("activity");
  }

  private static FileTree tree(Path root) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> paths = Files.walk(root)) {
      for (Path path : paths.filter(Files::isRegularFile).toList()) {
        files.put(root.relativize(path).toString().replace('\\', '/'), Files.readAllBytes(path));
      }
    }
    return FileTree.of(files);
  }

  @ParameterizedTest
  @ValueSource(strings = {"ir-sensor-python", "navigator"})
  void generatesTheGoldenSources(String name) throws IOException {
    Activity activity = Activity.read(tree(activity(name)));
    var model = activity.models().get(0);
    TestApplication application =
        InterfaceTestApplicationGenerator.generate(
            activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
    FileTree harness = application.harness();
    Path folder = GOLDENS.resolve(name).resolve("harness");
    if (UPDATE_GOLDEN) {
      for (String path : harness.paths()) {
        Files.createDirectories(folder.resolve(path).getParent());
        Files.write(folder.resolve(path), harness.content(path).orElseThrow());
      }
      Files.write(
          GOLDENS.resolve(name).resolve("suite.xml"),
          application.files().content("suite.xml").orElseThrow());
    }
    FileTree golden = tree(folder);
    assertThat(harness.paths()).isEqualTo(golden.paths());
    for (String path : harness.paths()) {
      assertThat(harness.text(path))
          .as(
              "%s (after an intended change: run this test with -Dsitaf.golden.update=true, and"
                  + " review the diff)",
              path)
          .isEqualTo(golden.text(path));
    }
  }
}
