package org.sitaf.core.beginning.choice;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.node.NodePackage;
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
public record InterfaceChoice(String path, FileTree files, List<InterfaceDescription> provided) {
  private static final String MANIFEST = "package.xml";
  private static final FileTree NONE = FileTree.of(Map.of());
  private static final String OWN =
      """
      // The interface of the component under test. Replace it by your own.
      interface Controller {
        // The command for a measured value that shall become the target.
        double Step(in double target, in double measured);
      };
      """;

  public InterfaceChoice {
    provided = List.copyOf(provided);
  }

  /** A small interface to begin with. */
  public static InterfaceChoice own() {
    return read(
        "Controller.idl",
        FileTree.of(Map.of("Controller.idl", OWN.getBytes(StandardCharsets.UTF_8))));
  }

  /**
   * The interface of a given file, or of ROS 2 such as {@code nav_msgs/srv/GetPlan.srv}.
   *
   * @param given the user's files
   * @param installed interface files of ROS 2
   * @throws InvalidInputException if there is no such file, or it has errors
   */
  public static InterfaceChoice of(String path, FileTree given, FileTree installed) {
    if (!given.contains(path) && installed.contains(path)) {
      FileTree needed = InterfaceClosure.of(path, NONE, installed);
      return new InterfaceChoice(path, NONE, read(path, needed).provided());
    }
    requireSupported(path);
    if (!given.contains(path)) {
      throw InvalidInputException.of(
          path, "is neither a given file nor an installed interface of ROS 2");
    }
    Optional<String> folder = InterfacePlace.packageOf(path);
    if (folder.isPresent()) {
      Optional<String> renamed = renamed(folder.get(), given);
      if (renamed.isPresent()) {
        FileTree moved = moved(folder.get(), renamed.get(), given);
        return of(moved(path, folder.get(), renamed.get()), moved, installed);
      }
    }
    InterfacePlace place = InterfacePlace.of(path);
    FileTree near = given.below(place.base());
    return read(place.path(), InterfaceClosure.of(place.path(), near, installed));
  }

  /** The folder of a package as its manifest names it, if its folder has another name or none. */
  private static Optional<String> renamed(String folder, FileTree given) {
    String above = folder.substring(0, folder.lastIndexOf('/') + 1);
    return given
        .text(folder.isEmpty() ? MANIFEST : folder + "/" + MANIFEST)
        .flatMap(NodePackage::nameIn)
        .map(name -> above + name)
        .filter(wanted -> !wanted.equals(folder));
  }

  /** The interface files of the package in another folder, next to all others. */
  private static FileTree moved(String folder, String to, FileTree given) {
    Map<String, byte[]> files = new HashMap<>();
    given.paths().stream()
        .filter(path -> InterfaceFiles.isSupported(path) && !path.endsWith("/" + MANIFEST))
        .forEach(
            path -> {
              boolean own = InterfacePlace.packageOf(path).orElse("/").equals(folder);
              files.put(own ? moved(path, folder, to) : path, given.content(path).orElseThrow());
            });
    try {
      return FileTree.of(files);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(to, String.valueOf(e.getMessage()));
    }
  }

  private static String moved(String path, String folder, String to) {
    return to + "/" + path.substring(folder.isEmpty() ? 0 : folder.length() + 1);
  }

  /**
   * Checks the extension of an interface file.
   *
   * @throws InvalidInputException if no importer reads such files
   */
  public static void requireSupported(String path) {
    if (!InterfaceFiles.isSupported(path)) {
      throw InvalidInputException.of(
          path, "is not an interface file: .xml (OPRoS), .idl, .srv, .action or .proto");
    }
  }

  private static InterfaceChoice read(String path, FileTree files) {
    Map<String, byte[]> all = new HashMap<>();
    files.paths().forEach(p -> all.put(p, files.content(p).orElseThrow()));
    ImportResult result =
        InterfaceFiles.read(SourceFiles.of("activity", all, List.of(path))).orThrow();
    return new InterfaceChoice(path, files, result.provided());
  }
}
