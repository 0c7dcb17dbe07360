package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds message types in the sources of a node: those of {@code create_publisher} and {@code
 * create_subscription} with a literal name, and the interface packages that it imports.
 */
public final class NodeSources {
  private static final int MAX_CHARACTERS = 1_000_000;
  private static final Pattern CREATED =
      Pattern.compile(
          "\\bcreate_(?:publisher|subscription)\\(\\s{0,100}(?:msg_type\\s?=\\s?)?([\\w.]{1,200})"
              + "\\s{0,100},\\s{0,100}(?:topic\\s?=\\s?)?(?:'([^'\\n]{1,200})'|\"([^\"\\n]{1,200})\")");
  private static final Pattern FILTERED =
      Pattern.compile(
          "\\bSubscriber\\(\\s{0,100}\\w{1,100},\\s{0,100}([\\w.]{1,200})\\s{0,100},\\s{0,100}"
              + "(?:'([^'\\n]{1,200})'|\"([^\"\\n]{1,200})\")");
  private static final Pattern CLIENT =
      Pattern.compile(
          "\\b(?:create_client\\(|ActionClient\\(\\s{0,100}\\w{1,100},)\\s{0,100}([\\w.]{1,200})"
              + "\\s{0,100},\\s{0,100}(?:'([^'\\n]{1,200})'|\"([^\"\\n]{1,200})\")");
  private static final Pattern IMPORT =
      Pattern.compile(
          "^[ \\t]*from[ \\t]+(\\w{1,200})\\.(?:msg|srv|action)(?:\\.\\w{1,200})?[ \\t]+import[ \\t]*"
              + "(\\([^)]{1,5000}\\)|[^\\n#]{1,5000})",
          Pattern.MULTILINE);
  private static final Pattern NAMED =
      Pattern.compile("([A-Z]\\w{0,200})(?:\\s{1,20}as\\s{1,20}(\\w{1,200}))?");
  private static final Pattern QUALIFIED =
      Pattern.compile("(\\w+)\\.(?:msg|srv|action)\\.([A-Z]\\w*)");
  private static final Pattern PACKAGE =
      Pattern.compile(
          "^[ \\t]*(?:from|import)[ \\t]+([a-z][a-z0-9_]{0,100})\\.(?:msg|srv|action)\\b",
          Pattern.MULTILINE);

  private static final Pattern CPP_SOURCE =
      Pattern.compile(".*\\.(cpp|cc|cxx|c\\+\\+|C|hpp|hxx|hh|h)");

  /** {@code create_publisher<TYPE>(NODE, "NAME"}, where the node may be missing. */
  private static final Pattern CPP_CREATED =
      Pattern.compile(
          "\\bcreate_(publisher|subscription|client)\\s{0,10}<\\s{0,100}([\\w:]{1,200})[^>;]{0,100}>\\s{0,100}"
              + "\\((?:\\s{0,100}[\\w>().-]{1,100},)?\\s{0,100}\"([^\"\\n]{1,200})\"");

  private static final Pattern CPP_ALIAS =
      Pattern.compile(
          "\\busing\\s{1,20}(\\w{1,200})\\s{0,20}=\\s{0,20}(?:::)?(\\w{1,200}::(?:msg|srv|action)::\\w{1,200})\\s{0,20};");
  private static final Pattern CPP_TYPE =
      Pattern.compile("(?:::)?(\\w+)::(?:msg|srv|action)::([A-Z]\\w*)");
  private static final Pattern CPP_PACKAGE =
      Pattern.compile(
          "^[ \\t]*#[ \\t]*include[ \\t]*[<\"]([a-z][a-z0-9_]{0,100})/(?:msg|srv|action)/",
          Pattern.MULTILINE);

  /** Types whose topics always have the same names. */
  private static final Map<String, String> FIXED =
      Map.of(
          "/tf", "tf2_msgs/TFMessage",
          "/tf_static", "tf2_msgs/TFMessage",
          "/clock", "rosgraph_msgs/Clock",
          "/rosout", "rcl_interfaces/Log",
          "/diagnostics", "diagnostic_msgs/DiagnosticArray",
          "/parameter_events", "rcl_interfaces/ParameterEvent");

  private final Map<String, SortedSet<String>> types = new HashMap<>();
  private final Map<String, SortedSet<String>> clients = new HashMap<>();
  private final SortedSet<String> packages = new TreeSet<>();

  /**
   * @param texts the node's sources
   * @param remap replaced names of the node
   * @param isCpp whether they are in C++
   */
  NodeSources(List<String> texts, Map<String, String> remap, boolean isCpp) {
    for (String text : texts) {
      if (text.length() > MAX_CHARACTERS) {
        continue;
      }
      if (isCpp) {
        scanCpp(text, remap);
      } else {
        scan(text, remap);
      }
    }
  }

  private void scan(String text, Map<String, String> remap) {
    Map<String, String> imported = new HashMap<>();
    Matcher line = IMPORT.matcher(text);
    while (line.find()) {
      Matcher name = NAMED.matcher(line.group(2));
      while (name.find()) {
        String type = line.group(1) + "/" + name.group(1);
        imported.put(name.group(2) == null ? name.group(1) : name.group(2), type);
      }
    }
    Matcher used = PACKAGE.matcher(text);
    while (used.find()) {
      packages.add(used.group(1));
    }
    for (Pattern pattern : List.of(CREATED, FILTERED, CLIENT)) {
      Matcher created = pattern.matcher(text);
      while (created.find()) {
        String written = created.group(1);
        Matcher qualified = QUALIFIED.matcher(written);
        String type =
            qualified.matches()
                ? qualified.group(1) + "/" + qualified.group(2)
                : imported.get(written);
        if (type != null) {
          String topic = created.group(2) == null ? created.group(3) : created.group(2);
          if (pattern == CLIENT) {
            clients.computeIfAbsent(type, t -> new TreeSet<>()).add(full(topic, remap));
          } else {
            types.computeIfAbsent(full(topic, remap), t -> new TreeSet<>()).add(type);
          }
        }
      }
    }
  }

  private void scanCpp(String text, Map<String, String> remap) {
    Map<String, String> aliases = new HashMap<>();
    Matcher alias = CPP_ALIAS.matcher(text);
    while (alias.find()) {
      aliases.put(alias.group(1), alias.group(2));
    }
    Matcher used = CPP_PACKAGE.matcher(text);
    while (used.find()) {
      packages.add(used.group(1));
    }
    Matcher created = CPP_CREATED.matcher(text);
    while (created.find()) {
      String written = aliases.getOrDefault(created.group(2), created.group(2));
      Matcher type = CPP_TYPE.matcher(written);
      if (type.matches()) {
        String name = type.group(1) + "/" + type.group(2);
        String topic = full(created.group(3), remap);
        if (created.group(1).equals("client")) {
          clients.computeIfAbsent(name, t -> new TreeSet<>()).add(topic);
        } else {
          types.computeIfAbsent(topic, t -> new TreeSet<>()).add(name);
        }
      }
    }
  }

  /** Whether a file is a source of a node. */
  public static boolean isSource(String path, boolean isCpp) {
    return isCpp ? CPP_SOURCE.matcher(path).matches() : path.endsWith(".py");
  }

  private static String full(String topic, Map<String, String> remap) {
    String replaced = remap.get(topic);
    if (replaced == null) {
      replaced = remap.get(topic.startsWith("/") ? topic.substring(1) : "/" + topic);
    }
    String name = replaced == null ? topic : replaced;
    return name.startsWith("/") ? name : "/" + name;
  }

  /** The types that the sources name for a topic. */
  List<String> typesOf(String topic) {
    String fixed = FIXED.get(topic);
    return fixed != null
        ? List.of(fixed)
        : new ArrayList<>(types.getOrDefault(topic, new TreeSet<>()));
  }

  /** The names of the services and actions of a type {@code package/Name} that the node calls. */
  List<String> clientsOf(String type) {
    return List.copyOf(clients.getOrDefault(type, new TreeSet<>()));
  }

  /** The interface packages that the sources import. */
  SortedSet<String> packages() {
    return packages;
  }
}
