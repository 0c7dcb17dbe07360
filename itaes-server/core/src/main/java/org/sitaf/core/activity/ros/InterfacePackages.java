package org.sitaf.core.activity.ros;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Files of interface packages as {@code PACKAGE/msg/NAME.msg}, and the packages that they use. */
final class InterfacePackages {
  /** Packages that every node uses, if only through its client library. */
  private static final List<String> ALWAYS =
      List.of(
          "action_msgs",
          "builtin_interfaces",
          "diagnostic_msgs",
          "geometry_msgs",
          "lifecycle_msgs",
          "nav_msgs",
          "rcl_interfaces",
          "rosgraph_msgs",
          "sensor_msgs",
          "service_msgs",
          "std_msgs",
          "std_srvs",
          "tf2_msgs",
          "type_description_interfaces",
          "unique_identifier_msgs");

  private static final Pattern PATH =
      Pattern.compile("(?:.*/)?([A-Za-z]\\w*)/(msg|srv|action)/(\\w+)\\.\\2");
  private static final Pattern USED =
      Pattern.compile("^\\s*([a-z][a-z0-9_]*)/(?:msg/)?[A-Z]", Pattern.MULTILINE);
  private static final Pattern PACKAGE_NAME = Pattern.compile("<name>\\s*([^<>\\s]+)\\s*</name>");

  private final Map<String, NavigableMap<String, byte[]>> packages = new HashMap<>();

  /**
   * @param activity files of the activity, whose packages replace those of the installation
   * @param installed files of the installation by path
   */
  InterfacePackages(Map<String, byte[]> activity, Map<String, byte[]> installed) {
    add(activity);
    Map<String, byte[]> others = new HashMap<>(installed);
    others
        .keySet()
        .removeIf(p -> packages.containsKey(p.substring(0, Math.max(0, p.indexOf('/')))));
    add(others);
  }

  private void add(Map<String, byte[]> files) {
    files.forEach(
        (path, content) -> {
          Matcher parts = PATH.matcher(path);
          if (parts.matches()) {
            String name = declaredName(files, path, parts.group(1));
            packages
                .computeIfAbsent(name, n -> new TreeMap<>())
                .put(
                    name + path.substring(path.lastIndexOf('/', path.lastIndexOf('/') - 1)),
                    content);
          }
        });
  }

  /** The name in {@code package.xml} of the folder, else the folder's. */
  private static String declaredName(Map<String, byte[]> files, String path, String folder) {
    String kind = path.substring(0, path.lastIndexOf('/'));
    byte[] manifest = files.get(kind.substring(0, kind.lastIndexOf('/') + 1) + "package.xml");
    if (manifest != null) {
      Matcher name = PACKAGE_NAME.matcher(new String(manifest, StandardCharsets.UTF_8));
      if (name.find() && name.group(1).matches("[a-z][a-z0-9_]*")) {
        return name.group(1);
      }
    }
    return folder;
  }

  /** The files of some packages, of those that every node uses, and of all that these use. */
  NavigableMap<String, byte[]> closure(Collection<String> wanted) {
    NavigableMap<String, byte[]> files = new TreeMap<>();
    Set<String> seen = new TreeSet<>(ALWAYS);
    seen.addAll(wanted);
    Deque<String> open = new ArrayDeque<>(seen);
    while (!open.isEmpty()) {
      NavigableMap<String, byte[]> found = packages.getOrDefault(open.pop(), new TreeMap<>());
      files.putAll(found);
      for (byte[] content : found.values()) {
        Matcher used = USED.matcher(new String(content, StandardCharsets.UTF_8));
        while (used.find()) {
          if (seen.add(used.group(1))) {
            open.push(used.group(1));
          }
        }
      }
    }
    return files;
  }
}
