package org.sitaf.agent.toolchain.cpp.inputs;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;

/**
 * The files of one test application, in its layout, and which of them a name in an include
 * directive means. Paths of a layout have no links and none of the parts {@code .} and {@code ..}.
 */
final class IncludeSearch {
  private static final String HARNESS = "harness/";
  private static final String ACTIVITY = "activity/";

  private final FileTree harness;
  private final FileTree activity;
  private final List<String> folders;
  private final Map<String, String> digests = new HashMap<>();
  private final Map<String, AskedNames> asked = new HashMap<>();

  /** By the name that finds it in the include folders; of several the first of these counts. */
  private final Map<String, String> reachable = new HashMap<>();

  /**
   * Looks through an application's files.
   *
   * @param folders of the layout in which names are looked for, in this order, without a slash at
   *     the end
   */
  IncludeSearch(FileTree harness, FileTree activity, List<String> folders) {
    this.harness = harness;
    this.activity = activity;
    this.folders = List.copyOf(folders);
    for (String folder : this.folders) {
      tree(folder + "/")
          .below(inTree(folder + "/"))
          .paths()
          .forEach(path -> reachable.putIfAbsent(path, folder + "/" + path));
    }
  }

  private FileTree tree(String path) {
    return path.startsWith(HARNESS) ? harness : activity;
  }

  private static String inTree(String path) {
    return path.substring(path.indexOf('/') + 1);
  }

  boolean contains(String path) {
    return (path.startsWith(HARNESS) || path.startsWith(ACTIVITY))
        && tree(path).contains(inTree(path));
  }

  /** All files, in order. */
  SortedSet<String> paths() {
    SortedSet<String> paths = new TreeSet<>();
    harness.paths().forEach(path -> paths.add(HARNESS + path));
    activity.paths().forEach(path -> paths.add(ACTIVITY + path));
    return paths;
  }

  private byte[] content(String path) {
    return tree(path).content(inTree(path)).orElseThrow();
  }

  synchronized String sha256(String path) {
    return digests.computeIfAbsent(path, p -> Machine.sha256(content(p)));
  }

  synchronized AskedNames asked(String path) {
    return asked.computeIfAbsent(path, p -> AskedNames.in(content(p)));
  }

  /** The names that would find a file in the include folders. */
  List<String> namesOf(String path) {
    List<String> names = new ArrayList<>();
    for (String folder : folders) {
      if (path.startsWith(folder + "/")) {
        names.add(path.substring(folder.length() + 1));
      }
    }
    return names;
  }

  /** What a name means to one of the application's files; null where nothing here. */
  @Nullable String find(AskedNames.Name name, String asking) {
    if (name.quoted()) {
      String next = normal(asking.substring(0, asking.lastIndexOf('/')) + "/" + name.text());
      if (next != null && contains(next)) {
        return next;
      }
    }
    return find(name.text());
  }

  /** What a name means in the include folders. */
  @Nullable String find(String name) {
    if (isPlain(name)) {
      return reachable.get(name);
    }
    for (String folder : folders) {
      String path = normal(folder + "/" + name);
      if (path != null && contains(path)) {
        return path;
      }
    }
    return null;
  }

  /** Those of some names that mean something in the include folders. */
  Map<String, String> findAll(SortedSet<String> names) {
    Map<String, String> found = new TreeMap<>();
    for (Map.Entry<String, String> entry : reachable.entrySet()) {
      if (names.contains(entry.getKey())) {
        found.put(entry.getKey(), entry.getValue());
      }
    }
    for (String name : names) {
      String path = isPlain(name) ? null : find(name);
      if (path != null) {
        found.put(name, path);
      }
    }
    return found;
  }

  private static boolean isPlain(String name) {
    return !name.startsWith(".") && !name.contains("/.") && !name.contains("//");
  }

  /** A path of the layout without the parts {@code .} and {@code ..}; null where it leaves it. */
  static @Nullable String normal(String path) {
    Deque<String> parts = new ArrayDeque<>();
    for (String part : path.split("/", -1)) {
      if (part.equals("..")) {
        if (parts.pollLast() == null) {
          return null;
        }
      } else if (!part.isEmpty() && !part.equals(".")) {
        parts.addLast(part);
      }
    }
    return String.join("/", parts);
  }

  /** A path that a tool printed, in the layout below a folder; null where it is not in there. */
  static @Nullable String inLayout(String printed, Path root) {
    return printed.startsWith(root + "/")
        ? normal(printed.substring(root.toString().length() + 1))
        : null;
  }
}
