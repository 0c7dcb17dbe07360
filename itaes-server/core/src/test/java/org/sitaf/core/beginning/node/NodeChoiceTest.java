package org.sitaf.core.beginning.node;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

class NodeChoiceTest {
  private static final FileTree PACKAGE =
      tree(
          Map.of(
              "package.xml", "<package><name>follower</name></package>",
              "follower/node.py", "import rclpy",
              "follower/build/kept.py", "",
              "follower/__pycache__/node.pyc", "",
              "build/node.py", "",
              "log/latest", "",
              ".git/config", ""));

  private static FileTree tree(Map<String, String> files) {
    Map<String, byte[]> contents = new HashMap<>();
    files.forEach((path, text) -> contents.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return FileTree.of(contents);
  }

  @Test
  void leavesOutHiddenFilesAndResultsOfBuilds() {
    NodeChoice choice = NodeChoice.of(PACKAGE, tree(Map.of()), "follower", null);

    assertThat(choice.chosen().files().paths())
        .containsExactly("follower/build/kept.py", "follower/node.py", "package.xml");
  }

  @Test
  void siblingsAreInterfaceFilesOfPackages() {
    FileTree parent =
        tree(
            Map.of(
                "own_msgs/package.xml", "",
                "own_msgs/msg/Cell.msg", "",
                "own_msgs/msg/notes.txt", "",
                "own_msgs/src/Cell.msg", "",
                "folder/msg/Cell.msg", "",
                "follower/package.xml", "",
                "follower/msg/Own.msg", ""));

    NodeChoice choice = NodeChoice.of(PACKAGE, parent, "follower", Language.PYTHON);

    assertThat(choice.siblings().paths()).containsExactly("own_msgs/msg/Cell.msg");
  }

  @Test
  void packagesInPythonThatTheNodeDependsOnComeAlong() {
    FileTree node =
        tree(
            Map.of(
                "package.xml",
                "<package><name>follower</name><depend>nav_utils</depend>"
                    + "<exec_depend>rclpy</exec_depend><test_depend>checks</test_depend></package>",
                "follower/node.py",
                "import rclpy"));
    FileTree parent =
        tree(
            Map.of(
                "nav_utils/package.xml", "<depend>geometry</depend><depend>nav_utils</depend>",
                "nav_utils/nav_utils/__init__.py", "",
                "nav_utils/build/copy.py", "",
                "nav_utils/README.md", "",
                "geometry/package.xml", "",
                "geometry/geometry/__init__.py", "",
                "checks/package.xml", "",
                "checks/checks/__init__.py", "",
                "other/package.xml", "",
                "other/other/__init__.py", ""));

    assertThat(NodeChoice.of(node, parent, "follower", null).siblings().paths())
        .containsExactly(
            "geometry/geometry/__init__.py",
            "geometry/package.xml",
            "nav_utils/nav_utils/__init__.py",
            "nav_utils/package.xml");
  }

  @Test
  void messagesNameTheFolderAsTheUserKnowsIt() {
    assertThatThrownBy(() -> NodeChoice.of(tree(Map.of()), tree(Map.of()), "ws/follower", null))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("ws/follower: error: has no package.xml");
  }
}
