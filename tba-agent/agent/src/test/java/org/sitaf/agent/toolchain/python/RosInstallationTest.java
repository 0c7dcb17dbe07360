package org.sitaf.agent.toolchain.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RosInstallationTest {
  private static final String PYTHON = "3.12.3";

  @TempDir private Path folder;

  private Path prefix(String path, String python) throws IOException {
    Path prefix = folder.resolve(path);
    Files.createDirectories(prefix.resolve("lib/python" + python + "/site-packages/rclpy"));
    Files.createDirectories(prefix.resolve("share/rclpy"));
    Files.writeString(
        prefix.resolve("share/rclpy/package.xml"), "<package><version>7.1.6</version></package>");
    return prefix;
  }

  private RosInstallation.Lookup find(Map<String, String> environment) throws IOException {
    return RosInstallation.find(
        PYTHON, environment, folder.resolve("opt/ros"), folder.resolve("dist-packages"));
  }

  @Test
  void prefersJazzyAmongWhatTheMachineHas() throws Exception {
    prefix("opt/ros/humble", "3.10");
    Path jazzy = prefix("opt/ros/jazzy", "3.12");
    Files.createDirectories(jazzy.resolve("opt/zenoh_vendor/lib"));
    prefix("opt/ros/rolling", "3.12");
    Path packages = Files.createDirectories(folder.resolve("dist-packages"));

    RosInstallation found = find(Map.of()).found().orElseThrow();

    assertThat(found.prefixes()).containsExactly(jazzy);
    assertThat(found.modules())
        .containsExactly(jazzy.resolve("lib/python3.12/site-packages"), packages);
    assertThat(found.libraries())
        .containsExactly(jazzy.resolve("lib"), jazzy.resolve("opt/zenoh_vendor/lib"));
  }

  @Test
  void takesWhatTheShellHasSourcedWithItsOverlays() throws Exception {
    Path overlay = Files.createDirectories(folder.resolve("overlay"));
    Path underlay = prefix("underlay", "3.12");
    Path built = Files.createDirectories(folder.resolve("build/my_msgs"));
    Path bundled = underlay.resolve("lib/python3.12/site-packages/ros_rclpy.libs");
    Files.createDirectories(bundled);

    RosInstallation found =
        find(Map.of(
                "AMENT_PREFIX_PATH",
                overlay + ":" + underlay + ":relative:" + folder + "/gone",
                "PYTHONPATH",
                built.toString(),
                "ROS_DISTRO",
                "jazzy"))
            .found()
            .orElseThrow();

    assertThat(found.version()).isEqualTo("jazzy");
    assertThat(found.prefixes()).containsExactly(overlay, underlay);
    assertThat(found.modules())
        .containsExactly(built, underlay.resolve("lib/python3.12/site-packages"));
    assertThat(found.readable()).contains(overlay, underlay, built, bundled);
    assertThat(found.environment())
        .containsEntry("AMENT_PREFIX_PATH", overlay + ":" + underlay)
        .containsEntry("LD_LIBRARY_PATH", bundled + ":" + underlay.resolve("lib"));
  }

  @Test
  void namesItsReleaseWithoutAName() throws Exception {
    Path prefix = prefix("ros", "3.12");

    assertThat(find(Map.of("AMENT_PREFIX_PATH", prefix.toString())).found().orElseThrow().version())
        .isEqualTo("rclpy 7.1.6");
  }

  @Test
  void saysWhatIsMissing() throws Exception {
    assertThat(find(Map.of()).problem())
        .isEqualTo(
            "no ROS 2 is installed in "
                + folder.resolve("opt/ros")
                + ", and AMENT_PREFIX_PATH is not set");

    Path other = prefix("opt/ros/jazzy", "3.10");

    assertThat(find(Map.of()).found()).isEmpty();
    assertThat(find(Map.of()).problem())
        .startsWith("the ROS 2 in " + other + " has no rclpy for Python 3.12");
  }
}
