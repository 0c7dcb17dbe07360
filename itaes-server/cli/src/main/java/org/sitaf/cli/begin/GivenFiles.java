package org.sitaf.cli.begin;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.choice.InterfaceChoice;
import org.sitaf.core.beginning.choice.InterfacePlace;
import org.sitaf.core.beginning.node.NodeChoice;
import org.sitaf.core.beginning.node.NodePackage;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Reads the files of which a new activity is made. */
final class GivenFiles {
  private static final FileTree NONE = FileTree.of(Map.of());
  private static final String MANIFEST = "package.xml";

  private GivenFiles() {}

  /**
   * The interface of a file, or of ROS 2 such as {@code nav_msgs/srv/GetPlan.srv}.
   *
   * @param installed interface files of ROS 2
   */
  static InterfaceChoice interfaceOf(Path file, FileTree installed) throws IOException {
    String named = file.toString().replace('\\', '/');
    if (!Files.exists(file) && installed.contains(named)) {
      return InterfaceChoice.of(named, NONE, installed);
    }
    InterfaceChoice.requireSupported(named);
    Path whole = file.toAbsolutePath().normalize();
    if (!Files.isRegularFile(whole)) {
      throw InvalidInputException.of(named, "does not exist");
    }
    Path root = Objects.requireNonNull(whole.getRoot());
    InterfacePlace place = InterfacePlace.of(root.relativize(whole).toString().replace('\\', '/'));
    Path base = root.resolve(place.base());
    Map<String, byte[]> files = new HashMap<>();
    for (String folder : place.folders()) {
      String prefix = folder.isEmpty() ? "" : folder + "/";
      add(base.resolve(folder), prefix, InterfaceFiles::isSupported, files);
    }
    files.put(place.path(), UserFiles.file(whole));
    return InterfaceChoice.of(place.path(), FileTree.of(files), installed);
  }

  /** The ROS 2 package of a folder, with the interfaces of the packages next to it. */
  static NodeChoice packageOf(Path folder, @Nullable Language language) throws IOException {
    if (!Files.isDirectory(folder)) {
      throw InvalidInputException.of(
          "--node " + folder, "is not a folder; name the folder of " + MANIFEST);
    }
    FileTree files = UserFiles.folder(folder);
    Path above = folder.toAbsolutePath().normalize().getParent();
    FileTree parent = above == null ? NONE : packagesIn(above, files.text(MANIFEST).orElse(""));
    return NodeChoice.of(files, parent, folder.toString(), language);
  }

  /**
   * The interface files of all packages of a folder, and the sources of those in Python on which a
   * package depends.
   */
  private static FileTree packagesIn(Path above, String manifest) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> packages = Files.list(above)) {
      for (Path sibling : (Iterable<Path>) packages.sorted()::iterator) {
        if (!Files.isRegularFile(sibling.resolve(MANIFEST))) {
          continue;
        }
        String name = sibling.getFileName() + "/";
        files.put(name + MANIFEST, new byte[0]);
        for (String kind : NodeChoice.INTERFACE_FOLDERS) {
          Predicate<String> wanted = path -> path.endsWith("." + kind);
          add(sibling.resolve(kind), name + kind + "/", wanted, files);
        }
      }
    }
    for (String name : NodePackage.dependencies(manifest, name -> pythonManifest(above, name))) {
      // Only the module: meshes and recordings next to it may be large.
      FileTree module = UserFiles.folder(above.resolve(name).resolve(name));
      module.paths().stream()
          .filter(path -> path.endsWith(".py"))
          .forEach(
              path ->
                  files.put(name + "/" + name + "/" + path, module.content(path).orElseThrow()));
      files.put(name + "/" + MANIFEST, UserFiles.file(above.resolve(name).resolve(MANIFEST)));
    }
    return FileTree.of(files);
  }

  /** The package.xml of a package in Python. */
  private static Optional<String> pythonManifest(Path above, String name) {
    Path manifest = above.resolve(name).resolve(MANIFEST);
    return Files.isRegularFile(manifest)
            && Files.isRegularFile(above.resolve(name).resolve(name).resolve("__init__.py"))
        ? Optional.of(new String(UserFiles.file(manifest), StandardCharsets.UTF_8))
        : Optional.empty();
  }

  private static void add(
      Path folder, String prefix, Predicate<String> wanted, Map<String, byte[]> files)
      throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> all = Files.list(folder)) {
      List<Path> found =
          all.filter(path -> wanted.test(path.toString()))
              .filter(path -> Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS))
              .sorted()
              .toList();
      for (Path path : found) {
        if (Files.size(path) <= InterfaceFiles.MAX_SIZE) {
          files.put(prefix + path.getFileName(), Files.readAllBytes(path));
        }
      }
    }
  }
}
