package org.sitaf.core.beginning.choice;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sitaf.core.beginning.node.NodeChoice;

/**
 * Where an interface file and the files that it refers to lie: in a package of ROS 2, or next to
 * each other.
 *
 * @param base the folder to which the others are relative; empty for the top
 * @param path of the file
 * @param folders folders of the files that it can refer to, and of the manifest of its package
 */
public record InterfacePlace(String base, String path, List<String> folders) {
  public InterfacePlace {
    folders = List.copyOf(folders);
  }

  /**
   * The place of a file.
   *
   * @param path with '/' separators
   */
  public static InterfacePlace of(String path) {
    String folder = parent(path);
    String ros = parent(folder);
    if (ros.isEmpty() || !NodeChoice.INTERFACE_FOLDERS.contains(name(folder))) {
      return new InterfacePlace(folder, name(path), List.of(""));
    }
    String packageName = name(ros);
    return new InterfacePlace(
        parent(ros),
        packageName + "/" + name(folder) + "/" + name(path),
        Stream.concat(
                Stream.of(packageName),
                NodeChoice.INTERFACE_FOLDERS.stream().map(f -> packageName + "/" + f))
            .toList());
  }

  /** The folder of the ROS 2 package that contains an interface file; empty for the top. */
  static Optional<String> packageOf(String path) {
    String folder = parent(path);
    String kind = name(folder);
    return NodeChoice.INTERFACE_FOLDERS.contains(kind) && path.endsWith("." + kind)
        ? Optional.of(parent(folder))
        : Optional.empty();
  }

  private static String parent(String path) {
    return path.substring(0, Math.max(0, path.lastIndexOf('/')));
  }

  private static String name(String path) {
    return path.substring(path.lastIndexOf('/') + 1);
  }
}
