package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosNode.End;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.activity.ros.RosNode.Topic;
import org.sitaf.core.document.YamlMapping;

/** Reads the entries of {@code activity.yaml} that only ROS 2 nodes have. */
public final class RosNodeReader {
  /** Entries of {@code component:} of a ROS 2 node. */
  public static final Set<String> COMPONENT_ENTRIES =
      Set.of(
          "language",
          "sources",
          "class",
          "main",
          "packages",
          "parameters",
          "remap",
          "environment",
          "stdin",
          "life_cycle");

  private static final Pattern NAME = Pattern.compile("/?[A-Za-z~][A-Za-z0-9_]*(/[A-Za-z0-9_]+)*");
  private static final Pattern END =
      Pattern.compile("(device|input|output)\\.([A-Za-z_][A-Za-z0-9_]*)|world");
  private static final Pattern TYPE =
      Pattern.compile("([a-z][a-z0-9_]*)/(?:msg/)?([A-Z][A-Za-z0-9]*)(?:\\.msg)?");
  private static final Pattern ENTRY =
      Pattern.compile("[A-Za-z_]\\w*(\\.[A-Za-z_]\\w*)*([:.][A-Za-z_]\\w*)");
  private static final Pattern CPP_CLASS =
      Pattern.compile("[A-Za-z_]\\w{0,200}(::[A-Za-z_]\\w{0,200}){0,20}");
  private static final Pattern CPP_FILE = Pattern.compile(".+\\.(cpp|cc|cxx|c\\+\\+|C)");
  private static final Pattern PACKAGE = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_.+-]{0,100}");
  private static final Pattern VARIABLE = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");
  private static final String ENDS = "device.NAME, input.NAME, output.NAME or world";
  private static final int MAX_TOPICS = 200;

  private RosNodeReader() {}

  /** Reads a node. Problems are reported through the mappings. */
  public static RosNode read(YamlMapping root, YamlMapping component) {
    component.allowOnly(COMPONENT_ENTRIES);
    boolean isMain = component.has("main");
    if (isMain == component.has("class")) {
      component.problem(
          "class",
          "a ROS 2 node needs exactly one of class (a subclass of Node) and main (module:function,"
              + " or a file)");
    }
    String entry = component.text(isMain ? "main" : "class").orElse("");
    boolean isCpp = component.text("language").orElse("").equalsIgnoreCase("ros2-cpp");
    boolean isFile = isMain && entry.endsWith(".py");
    if (isCpp) {
      cppEntry(component, entry, isMain);
    } else if (!entry.isEmpty() && !isFile && !ENTRY.matcher(entry).matches()) {
      component.problem(
          isMain ? "main" : "class",
          "'"
              + entry
              + "' is not "
              + (isMain
                  ? "module:function, such as my_package.follower:main, or a file, such as"
                      + " scripts/follower.py"
                  : "a class, such as my_package.follower:Follower"));
    }
    Map<String, Object> parameters = new LinkedHashMap<>();
    String parameterFile = null;
    Object given = component.data("parameters").orElse(Map.of());
    if (given instanceof String file) {
      parameterFile = file;
    } else if (given instanceof Map<?, ?> values) {
      values.forEach(
          (name, value) -> parameter(component, String.valueOf(name), value, parameters));
    } else {
      component.problem(
          "parameters", "must map names to values, or name a ROS parameter file of the activity");
    }
    Map<String, String> environment = texts(component, "environment");
    environment.keySet().stream()
        .filter(name -> !VARIABLE.matcher(name).matches())
        .forEach(
            name -> component.problem("environment", "'" + name + "' is no name of a variable"));
    return new RosNode(
        isCpp,
        entry,
        isMain,
        packages(component, isCpp),
        parameters,
        parameterFile,
        texts(component, "remap"),
        environment,
        stdin(component),
        topics(root),
        Map.of(),
        RosImplementation.INCLUDED);
  }

  private static void cppEntry(YamlMapping component, String entry, boolean isMain) {
    if (!entry.isEmpty() && !(isMain ? CPP_FILE : CPP_CLASS).matcher(entry).matches()) {
      component.problem(
          isMain ? "main" : "class",
          "'"
              + entry
              + "' is not "
              + (isMain
                  ? "a C++ source with the function main, such as src/follower_main.cpp"
                  : "a C++ class or component, such as my_package::Follower"));
    }
  }

  private static List<String> packages(YamlMapping component, boolean isCpp) {
    List<String> packages = component.texts("packages");
    if (!isCpp && !packages.isEmpty()) {
      component.problem(
          "packages", "is only for ros2-cpp; name Python packages in requirements.txt");
    }
    packages.stream()
        .filter(name -> !PACKAGE.matcher(name).matches())
        .forEach(name -> component.problem("packages", "'" + name + "' is no name of pkg-config"));
    return packages;
  }

  private static void parameter(
      YamlMapping component, String name, @Nullable Object value, Map<String, Object> into) {
    if (value instanceof Map<?, ?> nested) {
      nested.forEach((inner, v) -> parameter(component, name + "." + inner, v, into));
    } else if (value instanceof List<?> list
        && list.stream().anyMatch(item -> item instanceof Map || item instanceof List)) {
      component.problem("parameters", name + ": a list holds only numbers, texts or booleans");
    } else if (value != null) {
      into.put(name, value);
    }
  }

  private static Map<String, String> texts(YamlMapping component, String name) {
    Map<String, String> texts = new HashMap<>();
    component
        .mapping(name)
        .ifPresent(all -> all.names().forEach(n -> all.text(n).ifPresent(v -> texts.put(n, v))));
    return texts;
  }

  private static List<String> stdin(YamlMapping component) {
    List<String> inputs = new ArrayList<>();
    for (String line : component.texts("stdin")) {
      Matcher end = END.matcher(line);
      if (end.matches() && "input".equals(end.group(1))) {
        inputs.add(end.group(2));
      } else {
        component.problem("stdin", "'" + line + "' is not input.NAME");
      }
    }
    return inputs;
  }

  private static List<Topic> topics(YamlMapping root) {
    Optional<YamlMapping> found = root.mapping("topics");
    if (found.isEmpty()) {
      return List.of();
    }
    YamlMapping all = found.get();
    List<Topic> topics = new ArrayList<>();
    Set<String> names = new HashSet<>();
    Set<End> ends = new HashSet<>();
    for (String written : all.names()) {
      String name = written.startsWith("/") ? written : "/" + written;
      if (!NAME.matcher(written).matches() || written.startsWith("~")) {
        all.problem(written, "is not the name of a topic, such as /scan");
        continue;
      }
      if (!names.add(name)) {
        all.problem(written, "is listed twice; list what it is connected to, such as [a, b]");
      }
      Topic topic = topic(all, written, name);
      topics.add(topic);
      for (End end : topic.ends()) {
        if (end.kind() != EndKind.DEVICE && end.kind() != EndKind.WORLD && !ends.add(end)) {
          all.problem(written, "two topics are connected to " + shown(end));
        }
        if (end.name().equals(RosNode.PUBLISH) || end.name().equals("parameter")) {
          all.problem(written, "an input or output cannot be named " + end.name() + "; rename it");
        }
      }
    }
    if (topics.size() > MAX_TOPICS) {
      root.problem("topics", "lists more than " + MAX_TOPICS + " topics; split the activity");
    }
    Set<String> inputs = new HashSet<>();
    for (End end : ends) {
      if (!inputs.add(end.name())) {
        root.problem("topics", end.name() + " is both an input and an output; rename one of them");
      }
    }
    return topics;
  }

  private static Topic topic(YamlMapping all, String written, String name) {
    List<End> ends = new ArrayList<>();
    String frame = null;
    String type = null;
    for (YamlMapping.Item item : all.items(written)) {
      if (item.text() != null) {
        end(all, written, item.text()).ifPresent(ends::add);
        continue;
      }
      YamlMapping table = java.util.Objects.requireNonNull(item.mapping());
      table.allowOnly(Set.of("with", "frame_id", "type"));
      table.items("with").stream()
          .map(YamlMapping.Item::text)
          .filter(java.util.Objects::nonNull)
          .forEach(text -> end(all, written, text).ifPresent(ends::add));
      frame = table.text("frame_id").orElse(frame);
      type = table.text("type").flatMap(text -> type(table, text)).orElse(type);
    }
    if (ends.isEmpty()) {
      all.problem(written, "is connected to nothing; write " + ENDS);
    }
    for (EndKind kind : EndKind.values()) {
      if (ends.stream().filter(e -> e.kind() == kind).count() > 1) {
        all.problem(written, "is connected to two of the same kind; a topic has one of each");
      }
    }
    return new Topic(name, ends, frame, type, all.line(written));
  }

  private static Optional<String> type(YamlMapping table, String text) {
    Matcher type = TYPE.matcher(text);
    if (!type.matches()) {
      table.problem("type", "'" + text + "' is not a type such as geometry_msgs/msg/Twist");
      return Optional.empty();
    }
    return Optional.of(type.group(1) + "/" + type.group(2));
  }

  private static Optional<End> end(YamlMapping all, String topic, String text) {
    Matcher end = END.matcher(text);
    if (!end.matches()) {
      all.problem(topic, "'" + text + "' is not " + ENDS);
      return Optional.empty();
    }
    if (end.group(1) == null) {
      return Optional.of(new End(EndKind.WORLD, ""));
    }
    return Optional.of(
        new End(EndKind.valueOf(end.group(1).toUpperCase(java.util.Locale.ROOT)), end.group(2)));
  }

  /** An end as the document writes it. */
  static String shown(End end) {
    String kind = end.kind().name().toLowerCase(java.util.Locale.ROOT);
    return end.name().isEmpty() ? kind : kind + "." + end.name();
  }
}
