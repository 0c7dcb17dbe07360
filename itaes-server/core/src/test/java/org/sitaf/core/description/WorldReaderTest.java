package org.sitaf.core.description;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
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
  void knowsTheRaysOfLaserScanners() throws IOException {
    String file = "worlds/maze/maze.world.yaml";
    String text = Files.readString(EXAMPLES.resolve(file));
    WorldDescription world = WorldReader.read(text, file);

    assertThat(WorldSignals.lists(world)).isEqualTo(Map.of("lidar.ranges", 181));
    assertThat(WorldSignals.unit(world, "lidar.ranges[90]")).isEqualTo("m");
    assertThat(WorldSignals.unit(world, "min(lidar.ranges)")).isEqualTo("m");
    assertThat(WorldSignals.unit(world, "base.linear.command")).isEqualTo("m/s");
    assertThat(WorldSignals.unit(world, "robot_x")).isEmpty();
    for (String rays : new String[] {"1", "4097", "2.5", ".nan"}) {
      assertThatThrownBy(() -> WorldReader.read(text.replace("rays: 181", "rays: " + rays), file))
          .isInstanceOf(InvalidInputException.class)
          .hasMessageContaining("must be a whole number from 2 to 4096");
    }
  }

  @Test
  void rejectsUnknownEntries() {
    assertThatThrownBy(() -> WorldReader.read("mjcf: w.xml\nrobot: {}\n", "w.world.yaml"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("robot");
  }
}
