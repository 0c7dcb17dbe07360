package org.sitaf.core.activity.ros;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds message types in the sources of a node: those of publishers, subscriptions, clients and
 * servers that are created with a literal name, and the interface packages that it imports.
 */
public final class NodeSources {
  private static final int MAX_CHARACTERS = 1_000_000;
  private static final String TYPE_AND_NAME =
      "\\s{0,100}(?:\\w{1,20}_type\\s?=\\s?)?([\\w.]{1,200})\\s{0,100},\\s{0,100}"
          + "(?:(?:topic|srv_name|action_name)\\s?=\\s?)?(?:'([^'\\n]{1,200})'|\"([^\"\\n]{1,200})\")";

  /** {@code create_publisher(TYPE, 'NAME'}, {@code ActionServer(NODE, TYPE, 'NAME'} and others. */
  private static final Pattern CREATED =
      Pattern.compile(
          "\\b(create_(?:(?:lifecycle_)?publisher|subscription|client|service)\\(|"
              + "(?:Subscriber|ActionClient|ActionServer)\\(\\s{0,100}\\w{1,100},)"
              + TYPE_AND_NAME);

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

  /** {@code super().__init__('node', namespace='arm')}. */
  private static final Pattern NAMESPACE =
      Pattern.compile("\\bnamespace\\s?=\\s?['\"]/?(\\w[\\w/]{0,100}?)/?['\"]");

  /** {@code Node("node", "arm"}. */
  private static final Pattern CPP_NAMESPACE =
      Pattern.compile(
          "\\bNode\\(\\s{0,100}\"\\w{1,100}\"\\s{0,100},\\s{0,100}\"/?(\\w[\\w/]{0,100}?)/?\"");

  private static final Pattern CONTINUED = Pattern.compile("\\\\\\r?\\n");

  private static final Pattern CPP_SOURCE =
      Pattern.compile(".*\\.(cpp|cc|cxx|c\\+\\+|C|hpp|hxx|hh|h)");

  /** {@code create_publisher<TYPE>(NODE, "NAME"}, where the node may be missing or in parts. */
  private static final Pattern CPP_CREATED =
      Pattern.compile(
          "\\b(create_(?:publisher|subscription|client|service|server)|Subscriber)\\s{0,10}<\\s{0,100}"
              + "([\\w:]{1,200})[^>;]{0,100}>{1,2}\\s{0,100}"
              + "\\((?:\\s{0,100}[\\w>().-]{1,100},){0,4}\\s{0,100}\"([^\"\\n]{1,200})\"");

  /** {@code message_filters::Subscriber<TYPE> VARIABLE;}, which subscribes elsewhere. */
  private static final Pattern CPP_FILTER =
      Pattern.compile(
          "\\bSubscriber\\s{0,10}<\\s{0,100}([\\w:]{1,200})[^>;]{0,100}>{1,2}\\s{1,20}(\\w{1,100})\\s{0,10}[;{]");

  private static final Pattern CPP_SUBSCRIBED =
      Pattern.compile(
          "\\b(\\w{1,100})(?:\\.|->)subscribe\\(\\s{0,100}[\\w>().-]{1,100},\\s{0,100}\"([^\"\\n]{1,200})\"");

  private static final Pattern CPP_ALIAS =
      Pattern.compile(
          "\\busing\\s{1,20}(\\w{1,200})\\s{0,20}=\\s{0,20}(?:::)?(\\w{1,200}::(?:msg|srv|action)::\\w{1,200})\\s{0,20};");
  private static final Pattern CPP_USING =
      Pattern.compile(
          "\\busing\\s{1,20}(?:::)?(\\w{1,200}::(?:msg|srv|action)::(\\w{1,200}))\\s{0,20};");
  private static final Pattern CPP_TYPE =
      Pattern.compile("(?:::)?(\\w+)::(?:msg|srv|action)::([A-Z]\\w*)");
  private static final Pattern CPP_PACKAGE =
      Pattern.compile(
          "^[ \\t]*#[ \\t]*include[ \\t]*[<\"]([a-z][a-z0-9_]{0,100})/(?:msg|srv|action)/",
          Pattern.MULTILINE);

  /** What a node does with a topic, service or action. */
  public enum Kind {
    /** It sends messages. */
    PUBLISHER,
    /** It receives messages. */
    SUBSCRIPTION,
    /** It calls a service or action. */
    CLIENT,
    /** It provides a service or action. */
    SERVER
  }

  /**
   * A publisher, subscription, client or server.
   *
   * @param name of the topic, service or action, with a leading slash
   * @param type as {@code package/Name}
   */
  public record Endpoint(Kind kind, String name, String type) implements Comparable<Endpoint> {
    @Override
    public int compareTo(Endpoint other) {
      return Comparator.comparing(Endpoint::kind)
          .thenComparing(Endpoint::name)
          .thenComparing(Endpoint::type)
          .compare(this, other);
    }
  }

  /** Types whose topics always have the same names. */
  private static final Map<String, String> FIXED =
      Map.of(
          "/tf", "tf2_msgs/TFMessage",
          "/tf_static", "tf2_msgs/TFMessage",
          "/clock", "rosgraph_msgs/Clock",
          "/rosout", "rcl_interfaces/Log",
          "/diagnostics", "diagnostic_msgs/DiagnosticArray",
          "/parameter_events", "rcl_interfaces/ParameterEvent");

  private final SortedSet<Endpoint> endpoints = new TreeSet<>();
  private final SortedSet<String> packages = new TreeSet<>();

  /**
   * @param sources the node's sources
   * @param remap replaced names of the node
   * @param isCpp whether they are in C++
   */
  public NodeSources(List<String> sources, Map<String, String> remap, boolean isCpp) {
    List<String> texts = sources.stream().filter(t -> t.length() <= MAX_CHARACTERS).toList();
    for (String text : texts) {
      if (isCpp) {
        scanCpp(text, remap);
      } else {
        scan(joined(text), remap);
      }
    }
    if (isCpp) {
      filters(texts, remap);
    }
  }

  /** Subscribers of message filters, which a header declares and a source subscribes. */
  private void filters(List<String> texts, Map<String, String> remap) {
    Map<String, String> types = new HashMap<>();
    for (String text : texts) {
      Matcher declared = CPP_FILTER.matcher(text);
      while (declared.find()) {
        types.put(declared.group(2), declared.group(1));
      }
    }
    for (String text : texts) {
      Matcher subscribed = CPP_SUBSCRIBED.matcher(text);
      while (subscribed.find()) {
        Matcher type = CPP_TYPE.matcher(types.getOrDefault(subscribed.group(1), ""));
        if (type.matches()) {
          String name = full(subscribed.group(2), namespace(CPP_NAMESPACE, text), remap);
          endpoints.add(new Endpoint(Kind.SUBSCRIPTION, name, type.group(1) + "/" + type.group(2)));
        }
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
    String namespace = namespace(NAMESPACE, text);
    Matcher created = CREATED.matcher(text);
    while (created.find()) {
      String written = created.group(2);
      Matcher qualified = QUALIFIED.matcher(written);
      String type =
          qualified.matches()
              ? qualified.group(1) + "/" + qualified.group(2)
              : imported.get(written);
      if (type != null) {
        String name = created.group(3) == null ? created.group(4) : created.group(3);
        endpoints.add(new Endpoint(kind(created.group(1)), full(name, namespace, remap), type));
      }
    }
  }

  private static Kind kind(String call) {
    String lower = call.toLowerCase(Locale.ROOT);
    if (lower.contains("publisher")) {
      return Kind.PUBLISHER;
    }
    if (lower.contains("subscri")) {
      return Kind.SUBSCRIPTION;
    }
    return lower.contains("client") ? Kind.CLIENT : Kind.SERVER;
  }

  private void scanCpp(String text, Map<String, String> remap) {
    Map<String, String> aliases = new HashMap<>();
    Matcher alias = CPP_ALIAS.matcher(text);
    while (alias.find()) {
      aliases.put(alias.group(1), alias.group(2));
    }
    Matcher declared = CPP_USING.matcher(text);
    while (declared.find()) {
      aliases.put(declared.group(2), declared.group(1));
    }
    Matcher used = CPP_PACKAGE.matcher(text);
    while (used.find()) {
      packages.add(used.group(1));
    }
    String namespace = namespace(CPP_NAMESPACE, text);
    Matcher created = CPP_CREATED.matcher(text);
    while (created.find()) {
      String written = aliases.getOrDefault(created.group(2), created.group(2));
      Matcher type = CPP_TYPE.matcher(written);
      if (type.matches()) {
        String name = type.group(1) + "/" + type.group(2);
        endpoints.add(
            new Endpoint(kind(created.group(1)), full(created.group(3), namespace, remap), name));
      }
    }
  }

  /** A text in Python whose lines that are continued with a backslash are one. */
  public static String joined(String python) {
    return CONTINUED.matcher(python).replaceAll(" ");
  }

  /** Whether a file is a source of a node. */
  public static boolean isSource(String path, boolean isCpp) {
    return isCpp ? CPP_SOURCE.matcher(path).matches() : path.endsWith(".py");
  }

  /** The namespace of the only node in a source that names one; empty without one. */
  private static String namespace(Pattern pattern, String text) {
    SortedSet<String> found = new TreeSet<>();
    Matcher given = pattern.matcher(text);
    while (given.find()) {
      found.add(given.group(1));
    }
    return found.size() == 1 ? found.first() : "";
  }

  private static String full(String topic, String namespace, Map<String, String> remap) {
    String replaced = remap.get(topic);
    if (replaced == null) {
      replaced = remap.get(topic.startsWith("/") ? topic.substring(1) : "/" + topic);
    }
    String name = replaced == null ? topic : replaced;
    if (name.startsWith("/")) {
      return name;
    }
    return (namespace.isEmpty() || name.startsWith("~") ? "/" : "/" + namespace + "/") + name;
  }

  /** The types that the sources name for a topic. */
  List<String> typesOf(String topic) {
    String fixed = FIXED.get(topic);
    return fixed != null
        ? List.of(fixed)
        : distinct(
            e ->
                e.name().equals(topic)
                    && (e.kind() == Kind.PUBLISHER || e.kind() == Kind.SUBSCRIPTION),
            Endpoint::type);
  }

  /** The topics that the sources name. */
  List<String> topics() {
    return distinct(
        e -> e.kind() == Kind.PUBLISHER || e.kind() == Kind.SUBSCRIPTION, Endpoint::name);
  }

  /** The names of the services and actions of a type {@code package/Name} that the node calls. */
  List<String> clientsOf(String type) {
    return distinct(e -> e.kind() == Kind.CLIENT && e.type().equals(type), Endpoint::name);
  }

  private List<String> distinct(Predicate<Endpoint> wanted, Function<Endpoint, String> part) {
    return endpoints.stream().filter(wanted).map(part).distinct().sorted().toList();
  }

  /** The publishers, subscriptions, clients and servers with a literal name. */
  public List<Endpoint> endpoints() {
    return List.copyOf(endpoints);
  }

  /** The interface packages that the sources import. */
  public SortedSet<String> packages() {
    return packages;
  }
}
