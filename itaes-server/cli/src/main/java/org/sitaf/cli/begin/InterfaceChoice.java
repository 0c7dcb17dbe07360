package org.sitaf.cli.begin;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.InterfaceClosure;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The interface of a new activity.
 *
 * @param path its path in the activity, or among the interfaces of ROS 2
 * @param files the file and those that it refers to; none if it is installed
 * @param provided what it provides
 */
record InterfaceChoice(String path, FileTree files, List<InterfaceDescription> provided) {
  private static final Set<String> ROS_FOLDERS = Set.of("msg", "srv", "action");
  private static final String OWN =
      """
      // The interface of the component under test. Replace it by your own.
      interface Controller {
        // The command for a measured value that shall become the target.
        double Step(in double target, in double measured);
      };
      """;

  /** A small interface to begin with. */
  static InterfaceChoice own() {
    return read(
        "Controller.idl",
        FileTree.of(Map.of("Controller.idl", OWN.getBytes(StandardCharsets.UTF_8))));
  }

  /**
   * The interface of a file, or of ROS 2 such as {@code nav2_msgs/action/Spin.action}.
   *
   * @param installed interface files of ROS 2
   */
  static InterfaceChoice of(Path file, FileTree installed) {
    String named = file.toString().replace('\\', '/');
    if (!Files.exists(file) && installed.contains(named)) {
      FileTree needed = InterfaceClosure.of(named, FileTree.of(Map.of()), installed);
      return new InterfaceChoice(named, FileTree.of(Map.of()), read(named, needed).provided());
    }
    if (!InterfaceFiles.isSupported(named)) {
      throw InvalidInputException.of(
          named, "is not an interface file: .xml (OPRoS), .idl, .srv, .action or .proto");
    }
    Path whole = file.toAbsolutePath().normalize();
    Path folder = whole.getParent();
    if (folder == null || !Files.isRegularFile(whole)) {
      throw InvalidInputException.of(named, "does not exist");
    }
    Map<String, byte[]> candidates = new HashMap<>();
    Path ros = packageOf(folder);
    String path = String.valueOf(whole.getFileName());
    if (ros == null) {
      add(folder, "", candidates);
    } else {
      String name = String.valueOf(ros.getFileName());
      ROS_FOLDERS.forEach(f -> add(ros.resolve(f), name + "/" + f + "/", candidates));
      path = name + "/" + folder.getFileName() + "/" + path;
    }
    candidates.put(path, UserFiles.file(whole));
    return read(path, InterfaceClosure.of(path, FileTree.of(candidates), installed));
  }

  private static @Nullable Path packageOf(Path folder) {
    Path above = folder.getParent();
    return above != null
            && above.getFileName() != null
            && ROS_FOLDERS.contains(String.valueOf(folder.getFileName()))
        ? above
        : null;
  }

  private static InterfaceChoice read(String path, FileTree files) {
    Map<String, byte[]> all = new HashMap<>();
    files.paths().forEach(p -> all.put(p, files.content(p).orElseThrow()));
    ImportResult result =
        InterfaceFiles.read(SourceFiles.of("activity", all, List.of(path))).orThrow();
    return new InterfaceChoice(path, files, result.provided());
  }

  private static void add(Path folder, String prefix, Map<String, byte[]> files) {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> all = Files.list(folder)) {
      for (Path path : (Iterable<Path>) all.sorted()::iterator) {
        if (InterfaceFiles.isSupported(path.toString())
            && Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)
            && Files.size(path) <= InterfaceFiles.MAX_SIZE) {
          files.put(prefix + path.getFileName(), Files.readAllBytes(path));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
