package org.sitaf.core.description.importer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** The example of the paper, with its interface in each supported format. */
class ActivityInterfacesTest {
  private static final Path EXAMPLE = Path.of("../../examples/ir-sensor");

  private static FileTree example(String path, String text) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> all = Files.walk(EXAMPLE)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        files.put(EXAMPLE.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    String profile = new String(files.get("activity.yaml"), StandardCharsets.UTF_8);
    files.put(
        "activity.yaml",
        profile
            .replaceFirst("(?m)^provided:.*$", "provided: [" + path + "]")
            .getBytes(StandardCharsets.UTF_8));
    files.put(path, text.getBytes(StandardCharsets.UTF_8));
    String model = new String(files.get("GetInfraredData.xml"), StandardCharsets.UTF_8);
    files.put(
        "GetInfraredData.xml",
        model.replaceFirst("interface=\"\\w+\" ", "").getBytes(StandardCharsets.UTF_8));
    return FileTree.of(files);
  }

  @ParameterizedTest
  @CsvSource({
    "Infrared.idl,'module m { interface InfraredSensorService { void Enable();"
        + " double GetInfraredData(in long IndexOfSensor, in long NumOfSensor); }; };',"
        + "InfraredSensorService",
    "srv/GetInfraredData.srv,'int32 IndexOfSensor|int32 NumOfSensor|---|float64 distance',"
        + "ir_sensor"
  })
  void anActivityMayUseInterfacesOfEveryFormat(String path, String text, String name)
      throws IOException {
    FileTree files = example(path, text.replace('|', '\n'));
    if (name.equals("ir_sensor")) {
      String profile = files.text("activity.yaml").orElseThrow().replaceFirst("before: .*", "");
      files = files.with("activity.yaml", profile.getBytes(StandardCharsets.UTF_8));
    }
    Activity activity = Activity.read(files);
    assertThat(activity.provided()).hasSize(1);
    assertThat(activity.provided().get(0).name()).isEqualTo(name);
    assertThat(activity.provided().get(0).methodsNamed("GetInfraredData")).hasSize(1);
  }

  @Test
  void findsTheProvidedInterfacesOfAComponentProfile() throws IOException {
    String profile = Files.readString(EXAMPLE.resolve("InfraredSensorComp.xml"));
    Activity activity = Activity.read(example("InfraredSensorComp.xml", profile));
    assertThat(activity.provided())
        .extracting(i -> i.name() + " of " + i.source())
        .containsExactly("InfraredSensorService of InfraredSensorService.xml");
  }

  @Test
  void reportsErrorsOfAnInterfaceWithTheirLines() throws IOException {
    FileTree files = example("Infrared.idl", "interface A {\n double GetInfraredData(in long); };");
    assertThatThrownBy(() -> Activity.read(files))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("Infrared.idl:2: error: column 32");
  }
}
