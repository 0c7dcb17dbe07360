package org.sitaf.core.beginning.node;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The ROS 2 package of a new activity.
 *
 * @param siblings interface files of the packages next to it, and the whole packages in Python that
 *     a node in Python depends on
 */
public record NodeChoice(NodePackage chosen, FileTree siblings) {
  /** Folders of interface files, which have the same extension. */
  public static final List<String> INTERFACE_FOLDERS = List.of("action", "msg", "srv");

  private static final String MANIFEST = "package.xml";

  private static final Set<String> RESULTS_OF_BUILDS = Set.of("build", "install", "log");

  /**
   * Chooses a package.
   *
   * @param folder content of the folder of {@code package.xml}
   * @param parent content of its parent folder, of which the interface files of packages and the
   *     packages in Python that the node depends on are used
   * @param shown how messages name the folder
   * @param language Python or C++; null if the package decides
   * @throws InvalidInputException if it is no package with a node
   */
  public static NodeChoice of(
      FileTree folder, FileTree parent, String shown, @Nullable Language language) {
    Map<String, byte[]> sources = new HashMap<>();
    folder.paths().stream()
        .filter(NodeChoice::isSource)
        .forEach(path -> sources.put(path, folder.content(path).orElseThrow()));
    NodePackage chosen =
        NodePackage.of(
            FileTree.of(sources), shown, language == null ? null : language == Language.CPP);
    Map<String, byte[]> siblings = new HashMap<>();
    parent.paths().stream()
        .filter(path -> isInterfaceOfSibling(path, chosen.name(), parent))
        .forEach(path -> siblings.put(path, parent.content(path).orElseThrow()));
    if (!chosen.isCpp()) {
      addDependencies(chosen, parent, siblings);
    }
    return new NodeChoice(chosen, FileTree.of(siblings));
  }

  private static void addDependencies(
      NodePackage chosen, FileTree parent, Map<String, byte[]> siblings) {
    Function<String, Optional<String>> manifestOf =
        name ->
            name.equals(chosen.name()) || !parent.contains(name + "/" + name + "/__init__.py")
                ? Optional.empty()
                : parent.text(name + "/" + MANIFEST);
    for (String name : NodePackage.dependencies(chosen.text(MANIFEST), manifestOf)) {
      FileTree files = parent.below(name);
      files.paths().stream()
          .filter(NodeChoice::isSource)
          .filter(path -> path.endsWith(".py") || path.equals(MANIFEST))
          .forEach(path -> siblings.put(name + "/" + path, files.content(path).orElseThrow()));
    }
  }

  /** Whether a path is neither hidden nor a result of a build. */
  private static boolean isSource(String path) {
    List<String> parts = List.of(path.split("/", -1));
    return !(parts.size() > 1 && RESULTS_OF_BUILDS.contains(parts.get(0)))
        && parts.stream().noneMatch(part -> part.startsWith(".") || part.equals("__pycache__"));
  }

  private static boolean isInterfaceOfSibling(String path, String own, FileTree parent) {
    List<String> parts = List.of(path.split("/", -1));
    return parts.size() == 3
        && !parts.get(0).equals(own)
        && INTERFACE_FOLDERS.contains(parts.get(1))
        && parts.get(2).endsWith("." + parts.get(1))
        && parent.contains(parts.get(0) + "/package.xml");
  }

  /**
   * The activity of the package.
   *
   * @param name of the activity
   * @param entry class or main of the node; null for the only one
   * @param installed interface files of ROS 2
   */
  public NewNodeActivity activity(String name, @Nullable String entry, FileTree installed) {
    return new NewNodeActivity(name, chosen, entry, siblings, installed);
  }
}
