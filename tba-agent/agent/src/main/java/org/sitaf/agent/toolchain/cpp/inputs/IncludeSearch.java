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
import org.sitaf.core.digest.Sha256;

/**
 * Resolves names of include directives among the files of one test application. Paths are relative
 * to its layout and normalized.
 */
final class IncludeSearch {
  private static final String HARNESS = "harness/";
  private static final String ACTIVITY = "activity/";

  private final FileTree harness;
  private final FileTree activity;
  private final List<String> folders;
  private final Map<String, String> digests = new HashMap<>();
  private final Map<String, AskedNames> asked = new HashMap<>();

  /** File by the name that finds it; the first include folder wins. */
  private final Map<String, String> reachable = new HashMap<>();

  /**
   * Indexes the files of an application.
   *
   * @param folders the include path within the layout, without trailing slashes
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

  /** All files, sorted. */
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
    return digests.computeIfAbsent(path, p -> Sha256.hex(content(p)));
  }

  synchronized AskedNames asked(String path) {
    return asked.computeIfAbsent(path, p -> AskedNames.in(content(p)));
  }

  /** The names that find a file in the include folders. */
  List<String> namesOf(String path) {
    List<String> names = new ArrayList<>();
    for (String folder : folders) {
      if (path.startsWith(folder + "/")) {
        names.add(path.substring(folder.length() + 1));
      }
    }
    return names;
  }

  /**
   * The file that a name in one of the application's files refers to; null if it is not in the
   * application.
   */
  @Nullable String find(AskedNames.Name name, String asking) {
    if (name.quoted()) {
      String next = normal(asking.substring(0, asking.lastIndexOf('/')) + "/" + name.text());
      if (next != null && contains(next)) {
        return next;
      }
    }
    return find(name.text());
  }

  /** The file that a name refers to in the include folders. */
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

  /** The names that refer to a file in the include folders. */
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

  /** Normalizes a path of the layout; null if it leaves the layout. */
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

  /**
   * Converts a path printed by a tool to a path of the layout; null if it is outside of the folder.
   */
  static @Nullable String inLayout(String printed, Path root) {
    return printed.startsWith(root + "/")
        ? normal(printed.substring(root.toString().length() + 1))
        : null;
  }
}
