package org.sitaf.core.beginning.node;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.NodeSources;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * A ROS 2 package with a node.
 *
 * @param name as in {@code package.xml}
 * @param isCpp whether the node is written in C++, otherwise in Python
 * @param files without the results of builds
 */
public record NodePackage(String name, boolean isCpp, FileTree files) {
  private static final Pattern NAME =
      Pattern.compile("<name>\\s{0,100}([a-z][a-z0-9_]{0,100})\\s{0,100}</name>");

  private static final Pattern DEPENDENCY =
      Pattern.compile(
          "<(?:exec_)?depend>\\s{0,100}([a-z][a-z0-9_]{0,100})\\s{0,100}</(?:exec_)?depend>");

  /**
   * Reads a package.
   *
   * @param files content of the folder of {@code package.xml}
   * @param shown how messages name the folder
   * @param isCpp the wanted language; null if the package decides
   * @throws InvalidInputException if it is no package, or holds nodes in both languages
   */
  public static NodePackage of(FileTree files, String shown, @Nullable Boolean isCpp) {
    String manifest =
        files
            .text("package.xml")
            .orElseThrow(
                () ->
                    InvalidInputException.of(
                        shown, "has no package.xml; name the folder of a ROS 2 package"));
    String name =
        nameIn(manifest)
            .orElseThrow(
                () -> InvalidInputException.of(shown + "/package.xml", "names no package"));
    boolean python = uses(files, false, "rclpy");
    boolean cpp = uses(files, true, "rclcpp");
    boolean isChosenCpp = isCpp == null ? cpp : isCpp;
    if (isCpp == null && python && cpp) {
      throw InvalidInputException.of(
          shown, "holds nodes in Python and in C++; choose the language python or cpp");
    }
    if (!(isChosenCpp ? cpp : python)) {
      throw InvalidInputException.of(
          shown,
          "has no "
              + (isCpp == null ? "source" : isCpp ? "C++ source" : "Python source")
              + " that uses "
              + (isCpp == null ? "rclpy or rclcpp" : isCpp ? "rclcpp" : "rclpy"));
    }
    return new NodePackage(name, isChosenCpp, files);
  }

  /** The name in a {@code package.xml}. */
  public static Optional<String> nameIn(String manifest) {
    Matcher name = NAME.matcher(manifest);
    return name.find() ? Optional.of(name.group(1)) : Optional.empty();
  }

  /**
   * The packages on which one depends when it runs, also by way of others.
   *
   * @param manifest its {@code package.xml}
   * @param manifestOf the {@code package.xml} of a package; empty for one that is left out
   */
  public static Set<String> dependencies(
      String manifest, Function<String, Optional<String>> manifestOf) {
    Set<String> seen = new HashSet<>();
    Set<String> found = new TreeSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(manifest));
    while (!open.isEmpty()) {
      Matcher dependency = DEPENDENCY.matcher(open.remove());
      while (dependency.find()) {
        String name = dependency.group(1);
        Optional<String> next = seen.add(name) ? manifestOf.apply(name) : Optional.empty();
        if (next.isPresent()) {
          found.add(name);
          open.add(next.get());
        }
      }
    }
    return found;
  }

  private static boolean uses(FileTree files, boolean isCpp, String library) {
    return files.paths().stream()
        .filter(path -> NodeSources.isSource(path, isCpp))
        .anyMatch(path -> files.text(path).orElseThrow().contains(library));
  }

  /** The paths of its sources in the language of the node. */
  List<String> sources() {
    return files.paths().stream().filter(path -> NodeSources.isSource(path, isCpp)).toList();
  }

  /** The content of a source; lines that are continued with a backslash are one. */
  String text(String path) {
    String text = files.text(path).orElseThrow();
    return isCpp ? text : NodeSources.joined(text);
  }
}
