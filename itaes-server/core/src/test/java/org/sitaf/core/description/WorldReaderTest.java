package org.sitaf.core.description;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.diagnostic.InvalidInputException;

class WorldReaderTest {
  private static final Path EXAMPLES = Path.of("../../examples");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ir-sensor/world/ir.world.yaml",
        "worlds/maze/maze.world.yaml",
        "worlds/arm/arm.world.yaml",
        "worlds/base/base.world.yaml",
        "worlds/quadruped/quadruped.world.yaml"
      })
  void readsTheWorldsOfTheExamples(String file) throws IOException {
    WorldDescription world = WorldReader.read(Files.readString(EXAMPLES.resolve(file)), file);

    assertThat(world.parameters()).isNotEmpty();
    assertThat(world.devices()).isNotEmpty();
    assertThat(world.observations()).isNotEmpty();
  }

  @Test
  void rejectsUnknownEntries() {
    assertThatThrownBy(() -> WorldReader.read("mjcf: w.xml\nrobot: {}\n", "w.world.yaml"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("robot");
  }
}
