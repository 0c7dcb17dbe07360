package org.sitaf.core.harness;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Compares generated adapters with golden files, and checks the errors about missing adapters. */
class AdapterTest {
  private static final Path RESOURCES = Path.of("src/test/resources/org/sitaf/core/harness");
  private static final boolean UPDATE_GOLDEN = Boolean.getBoolean("sitaf.golden.update");

  private static FileTree activity(String language, String className) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    for (String name : new String[] {"planner.idl", "finder.idl", "w.world.yaml", "Plan.xml"}) {
      files.put(name, Files.readAllBytes(RESOURCES.resolve("cpp/wide-activity").resolve(name)));
    }
    String planner = new String(files.get("planner.idl"), StandardCharsets.UTF_8);
    String raising =
        "exception Busy {};\n" + planner.replace("in Mode mode);", "in Mode mode) raises (Busy);");
    files.put("planner.idl", raising.getBytes(StandardCharsets.UTF_8));
    files.put(
        "activity.yaml",
        """
        name: wide
        component: {language: %s, sources: component/, adapter: adapter/, class: %s}
        provided: [planner.idl]
        required: [finder.idl]
        world: w.world.yaml
        models: [Plan.xml]
        """
            .formatted(language, className)
            .getBytes(StandardCharsets.UTF_8));
    files.put("component/notes.txt", new byte[] {'\n'});
    return FileTree.of(files);
  }

  @ParameterizedTest
  @CsvSource({
    "java, robot.PlannerAdapter",
    "python, planner_adapter.PlannerAdapter",
    "cpp, robot::PlannerAdapter"
  })
  void generatesTheGoldenAdapters(String language, String className) throws IOException {
    FileTree adapter =
        InterfaceTestApplicationGenerator.adapter(
            Activity.readWithoutComponent(activity(language, className)));
    assertThat(adapter.paths()).isNotEmpty().allMatch(p -> p.startsWith("adapter/"));
    for (String path : adapter.paths()) {
      Path golden = RESOURCES.resolve("adapter").resolve(language).resolve(path);
      if (UPDATE_GOLDEN) {
        Files.createDirectories(golden.getParent());
        Files.write(golden, adapter.content(path).orElseThrow());
      }
      assertThat(adapter.text(path))
          .as(
              "%s (after an intended change: run this test with -Dsitaf.golden.update=true, and"
                  + " review the diff)",
              path)
          .contains(Files.readString(golden));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "java, robot.PlannerAdapter",
    "python, planner_adapter.PlannerAdapter",
    "cpp, robot::PlannerAdapter"
  })
  void explainsHowToCreateAMissingAdapter(String language, String className) throws IOException {
    FileTree files = activity(language, className);
    assertThatThrownBy(() -> Activity.read(files))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("the activity has no file below 'adapter/'")
        .hasMessageContaining("./sitaf harness ACTIVITY_DIR --adapter");
    FileTree other = files.with("adapter/notes.txt", new byte[] {'\n'});
    assertThatThrownBy(
            () -> {
              Activity activity = Activity.read(other);
              var model = activity.models().get(0);
              var suite =
                  org.sitaf.core.suite.TestCaseGenerator.generate(
                          model, org.sitaf.core.suite.GenerationOptions.DEFAULT)
                      .suite();
              InterfaceTestApplicationGenerator.generate(activity, model, suite);
            })
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("component.class")
        .hasMessageContaining("./sitaf harness ACTIVITY_DIR --adapter");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Planner", "RangeFinder", "Mode", "Hardware"})
  void aJavaAdapterMayHaveTheNameOfAUsedType(String name) throws IOException {
    String source =
        InterfaceTestApplicationGenerator.adapter(
                Activity.readWithoutComponent(activity("java", "robot." + name)))
            .text("adapter/robot/" + name + ".java")
            .orElseThrow();

    assertThat(source)
        .contains("public final class " + name + " implements ", "public " + name + "(")
        .doesNotContainPattern("import [\\w.]+\\." + name + ";")
        .containsPattern("(sitaf\\.interfaces|org\\.sitaf\\.runtime)\\." + name + "\\b");
  }

  @Test
  void rejectsNamesThatAreInvalidInALanguage() throws IOException {
    for (String[] bad :
        new String[][] {
          {"java", "robot.Plan ner"},
          {"java", "Planner"},
          {"python", "planner.py/../x.Planner"},
          {"cpp", "robot::../Planner"}
        }) {
      Activity activity = Activity.readWithoutComponent(activity(bad[0], '"' + bad[1] + '"'));
      assertThatThrownBy(() -> InterfaceTestApplicationGenerator.adapter(activity))
          .as(bad[1])
          .isInstanceOf(InvalidInputException.class)
          .hasMessageContaining("component.class");
    }
  }
}
