package org.sitaf.cli.begin;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.node.NewNodeActivity;
import org.sitaf.core.beginning.node.NodePackage;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The ROS 2 package of a new activity.
 *
 * @param siblings interface files of the packages next to it
 */
record NodeChoice(NodePackage chosen, FileTree siblings) {
  private static final List<String> RESULTS_OF_BUILDS =
      List.of("build/", "install/", "log/", "__pycache__/");

  static NodeChoice of(Path folder, @Nullable Language language) throws IOException {
    if (!Files.isDirectory(folder)) {
      throw InvalidInputException.of(
          "--node " + folder, "is not a folder; name the folder of package.xml");
    }
    FileTree whole = UserFiles.folder(folder);
    Map<String, byte[]> files = new TreeMap<>();
    whole.paths().stream()
        .filter(path -> RESULTS_OF_BUILDS.stream().noneMatch(path::startsWith))
        .filter(path -> !path.contains("/__pycache__/"))
        .forEach(path -> files.put(path, whole.content(path).orElseThrow()));
    NodePackage chosen =
        NodePackage.of(
            FileTree.of(files),
            folder.toString(),
            language == null ? null : language == Language.CPP);
    return new NodeChoice(chosen, siblings(folder, chosen.name()));
  }

  NewNodeActivity activity(String name, @Nullable String entry, FileTree installed) {
    return new NewNodeActivity(name, chosen, entry, siblings, installed);
  }

  private static FileTree siblings(Path folder, String own) throws IOException {
    Path above = folder.toAbsolutePath().normalize().getParent();
    Map<String, byte[]> files = new HashMap<>();
    if (above == null) {
      return FileTree.of(files);
    }
    try (Stream<Path> packages = Files.list(above)) {
      for (Path sibling : (Iterable<Path>) packages.sorted()::iterator) {
        String name = String.valueOf(sibling.getFileName());
        if (!name.equals(own) && Files.isRegularFile(sibling.resolve("package.xml"))) {
          for (String kind : List.of("msg", "srv", "action")) {
            add(sibling.resolve(kind), name + "/" + kind + "/", "." + kind, files);
          }
        }
      }
    }
    return FileTree.of(files);
  }

  private static void add(Path folder, String prefix, String ending, Map<String, byte[]> files)
      throws IOException {
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    try (Stream<Path> all = Files.list(folder)) {
      for (Path file : (Iterable<Path>) all.sorted()::iterator) {
        String name = Objects.requireNonNull(file.getFileName()).toString();
        if (name.endsWith(ending) && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
          files.put(prefix + name, UserFiles.file(file));
        }
      }
    }
  }
}
