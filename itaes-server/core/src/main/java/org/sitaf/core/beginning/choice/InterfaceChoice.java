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
   * The interface of a given file, or of ROS 2 such as {@code nav2_msgs/action/Spin.action}.
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
    if (InterfacePlace.isAtTopOfPackage(path) && given.contains(MANIFEST)) {
      Optional<String> name = NodePackage.nameIn(given.text(MANIFEST).orElseThrow());
      if (name.isPresent()) {
        return of(name.get() + "/" + path, within(name.get(), given), installed);
      }
    }
    InterfacePlace place = InterfacePlace.of(path);
    FileTree near = given.below(place.base());
    return read(place.path(), InterfaceClosure.of(place.path(), near, installed));
  }

  /** The interface files of a package below the name of the package. */
  private static FileTree within(String packageName, FileTree given) {
    Map<String, byte[]> files = new HashMap<>();
    given.paths().stream()
        .filter(InterfacePlace::isAtTopOfPackage)
        .forEach(p -> files.put(packageName + "/" + p, given.content(p).orElseThrow()));
    return FileTree.of(files);
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
