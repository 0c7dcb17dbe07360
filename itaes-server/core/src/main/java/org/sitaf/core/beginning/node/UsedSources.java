package org.sitaf.core.beginning.node;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.combine.Interruption;

/** Finds the sources of a package that one of its nodes uses, so that other nodes say nothing. */
final class UsedSources {
  private static final Pattern IMPORT =
      Pattern.compile(
          "^[ \\t]*(?:from[ \\t]+(\\.{0,3}[\\w.]{0,200})[ \\t]+import[ \\t]*(\\([\\w,\\s]{1,500}|[\\w, \\t]{1,500})|import[ \\t]+([\\w.]{1,200}))",
          Pattern.MULTILINE);
  private static final Pattern INCLUDE =
      Pattern.compile(
          "^[ \\t]*#[ \\t]*include[ \\t]*[<\"]([^>\"\\n]{1,200})[>\"]", Pattern.MULTILINE);

  private final NodePackage given;
  private final List<String> sources;
  private final SortedSet<String> used = new TreeSet<>();

  private UsedSources(NodePackage given) {
    this.given = given;
    this.sources = given.sources();
  }

  /** The paths of the entry's source and of those that it imports or includes. */
  static List<String> of(NodePackage given, NodeEntry entry) {
    UsedSources sources = new UsedSources(given);
    Deque<String> open = new ArrayDeque<>(List.of(entry.file()));
    while (!open.isEmpty()) {
      String path = open.remove();
      Interruption.check();
      if (sources.used.add(path)) {
        open.addAll(given.isCpp() ? sources.included(path) : sources.imported(path));
      }
    }
    return List.copyOf(sources.used);
  }

  private Collection<String> imported(String path) {
    SortedSet<String> found = new TreeSet<>();
    Matcher line = IMPORT.matcher(given.text(path));
    while (line.find()) {
      if (line.group(3) != null) {
        add(line.group(3).replace('.', '/'), found);
        continue;
      }
      String module = line.group(1);
      String folder = "";
      if (module.startsWith(".")) {
        int dots = (int) module.chars().takeWhile(c -> c == '.').count();
        folder = parent(path, dots);
        module = module.substring(dots);
      }
      String base = join(folder, module.replace('.', '/'));
      add(base, found);
      for (String name : line.group(2).split("[(,\\s]+", 100)) {
        add(join(base, name), found);
      }
    }
    return found;
  }

  private void add(String module, SortedSet<String> found) {
    if (given.files().contains(module + ".py")) {
      found.add(module + ".py");
    }
  }

  private static String parent(String path, int levels) {
    String folder = path;
    for (int i = 0; i < levels; i++) {
      folder = folder.substring(0, Math.max(0, folder.lastIndexOf('/')));
    }
    return folder;
  }

  private static String join(String folder, String name) {
    return folder.isEmpty() ? name : name.isEmpty() ? folder : folder + "/" + name;
  }

  /** Headers of the package, and the sources that are named after them. */
  private Collection<String> included(String path) {
    SortedSet<String> found = new TreeSet<>();
    Matcher include = INCLUDE.matcher(given.text(path));
    while (include.find()) {
      Interruption.check();
      String named = include.group(1).replaceFirst("^(?:\\.\\.?/)+", "");
      for (String source : sources) {
        if (source.equals(named) || source.endsWith("/" + named)) {
          found.add(source);
          found.addAll(namesakes(source));
        }
      }
    }
    return found;
  }

  private List<String> namesakes(String header) {
    String stem = stem(header);
    return sources.stream().filter(source -> stem(source).equals(stem)).toList();
  }

  private static String stem(String path) {
    String file = path.substring(path.lastIndexOf('/') + 1);
    return file.substring(0, Math.max(0, file.lastIndexOf('.')));
  }
}
