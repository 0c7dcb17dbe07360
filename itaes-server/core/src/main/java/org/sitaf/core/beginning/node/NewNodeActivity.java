package org.sitaf.core.beginning.node;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.NodeSources;
import org.sitaf.core.activity.ros.NodeSources.Endpoint;
import org.sitaf.core.activity.ros.NodeSources.Kind;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.beginning.LifecycleProposal;
import org.sitaf.core.beginning.ModelProposal;
import org.sitaf.core.beginning.Proposal;
import org.sitaf.core.beginning.YamlScalar;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * What a new activity of a ROS 2 node is made of: its package, unchanged, with its topics, services
 * and actions as far as the sources name them.
 *
 * @param name name of the activity
 * @param entry class or main of the node; null for the only one
 * @param siblings interface files of packages next to it by {@code PACKAGE/msg/NAME.msg}, and whole
 *     packages in Python, with their {@code package.xml}, that the node depends on
 * @param installed interface files of ROS 2
 */
public record NewNodeActivity(
    String name, NodePackage given, @Nullable String entry, FileTree siblings, FileTree installed) {
  private static final Pattern DECLARED =
      Pattern.compile(
          "\\bdeclare_parameter\\s{0,10}(?:<[^>;\\n]{1,100}>)?\\s{0,10}\\(\\s{0,100}['\"]([\\w.]{1,100})['\"]");
  private static final Pattern USED_PACKAGE =
      Pattern.compile("^\\s{0,100}([a-z][a-z0-9_]{0,100})/\\w", Pattern.MULTILINE);
  private static final Pattern CREATION =
      Pattern.compile(
          "\\b(?:create_(?:(?:lifecycle_)?publisher|subscription|service|client|server)\\s?[<(]|Action(?:Client|Server)\\()");

  private static final Pattern TOPIC = Pattern.compile("/[A-Za-z]\\w*(?:/[A-Za-z0-9_]+)*");

  /** Topics of every node, and those that a world serves. */
  private static final Set<String> PASSED_OVER =
      Set.of("/rosout", "/parameter_events", "/clock", "/tf", "/tf_static");

  /** Name of the model over transitions. */
  private static final String LIFE_CYCLE = "LifeCycle";

  private static final Set<String> TAKEN = Set.of(RosNode.PUBLISH, "parameter", RosNode.INTERFACE);

  /**
   * The files of the activity, and notes about what its sources did not tell.
   *
   * @throws InvalidInputException if there is no node that can be tested
   * @throws SeveralNodesException if there are several nodes, and none was chosen
   */
  public Proposal propose() {
    NodeEntry chosen = new NodeEntries(given).choose(entry);
    List<String> used = UsedSources.of(given, chosen);
    List<String> texts = used.stream().map(given::text).toList();
    NodeSources sources = new NodeSources(texts, Map.of(), given.isCpp());
    List<String> notes = new ArrayList<>();
    Map<String, byte[]> all = new HashMap<>();
    given
        .files()
        .paths()
        .forEach(path -> all.put(folder() + "/" + path, given.files().content(path).orElseThrow()));
    needed(sources.packages())
        .forEach(path -> all.put("src/" + path, siblings.content(path).orElseThrow()));
    libraries()
        .forEach(
            folder ->
                siblings.below(folder).paths().stream()
                    .map(path -> folder + "/" + path)
                    .forEach(path -> all.put("src/" + path, siblings.content(path).orElseThrow())));
    String profile = profile(chosen, sources, texts, tree(all), notes);
    all.put("activity.yaml", bytes(profile + end(List.of())));
    Activity withoutModels = Activity.read(tree(all), installed);
    List<String> models = new ArrayList<>();
    models(withoutModels)
        .forEach(
            (model, text) -> {
              models.add(model + ".xml");
              all.put(model + ".xml", bytes(text));
            });
    all.put("activity.yaml", bytes(profile + end(models)));
    FileTree files = tree(all);
    for (TestModel model : Activity.read(files, installed).models()) {
      var unused = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    }
    unnamed(used).forEach(notes::add);
    return new Proposal(files, notes);
  }

  /** The interface files of the named packages that are not installed, and of those they use. */
  private Set<String> needed(Set<String> packages) {
    Deque<String> open = new ArrayDeque<>(packages);
    Set<String> seen = new HashSet<>();
    Set<String> needed = new TreeSet<>();
    while (!open.isEmpty()) {
      String wanted = open.remove();
      if (!seen.add(wanted) || !installed.below(wanted).paths().isEmpty()) {
        continue;
      }
      for (String path : siblings.below(wanted).paths()) {
        needed.add(wanted + "/" + path);
        Matcher used = USED_PACKAGE.matcher(siblings.text(wanted + "/" + path).orElseThrow());
        while (used.find()) {
          open.add(used.group(1));
        }
      }
    }
    return needed;
  }

  /** The packages in Python that come along. */
  private List<String> libraries() {
    String end = "/package.xml";
    return siblings.paths().stream()
        .filter(path -> path.endsWith(end))
        .map(path -> path.substring(0, path.length() - end.length()))
        .toList();
  }

  private String folder() {
    return "src/" + given.name();
  }

  /** The paths of a package are longer in the activity. */
  private FileTree tree(Map<String, byte[]> files) {
    try {
      return FileTree.of(files);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(given.name(), String.valueOf(e.getMessage()));
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private String profile(
      NodeEntry chosen,
      NodeSources sources,
      List<String> texts,
      FileTree files,
      List<String> notes) {
    StringBuilder text = new StringBuilder();
    text.append("name: ").append(YamlScalar.of(name)).append('\n');
    text.append("description: \"\"   # Say in one sentence what is tested.\n");
    text.append("component:\n");
    text.append("  language: ").append(given.isCpp() ? "ros2-cpp" : "ros2-python").append('\n');
    text.append("  sources: ").append(folder()).append('\n');
    text.append(chosen.isMain() ? "  main: " : "  class: ")
        .append(YamlScalar.of(chosen.name()))
        .append('\n');
    Set<String> parameters = parameters(texts);
    text.append("  # Parameters that the node declares: ")
        .append(parameters.isEmpty() ? "none was found" : String.join(", ", parameters))
        .append(".\n");
    text.append("  # parameters: {NAME: VALUE}\n");
    text.append(
        "# input: published by the test. output: recorded. A topic can also be a device of a\n");
    text.append("# world, such as device.lidar.\n");
    Map<String, String> topics = topics(sources, notes);
    text.append(topics.isEmpty() ? "topics: {}\n" : "topics:\n");
    topics.forEach(
        (topic, ends) -> text.append("  ").append(topic).append(": ").append(ends).append('\n'));
    List<String> provided = services(sources, Kind.SERVER, files, notes);
    provided.addAll(LifecycleServices.of(texts, installed));
    text.append("provided: ").append(shown(provided)).append('\n');
    text.append("# Services and actions that the node calls; the test stub answers them.\n");
    text.append("required: ")
        .append(shown(services(sources, Kind.CLIENT, files, notes)))
        .append('\n');
    if (!libraries().isEmpty()) {
      text.append("# Packages that the node depends on.\n");
      text.append("libraries: ")
          .append(libraries().stream().map(folder -> "src/" + folder).toList())
          .append('\n');
    }
    return text.toString();
  }

  /** The end of {@code activity.yaml}, which names the models. */
  private static String end(List<String> models) {
    return "models: [" + String.join(", ", models) + "]\nlimits: {case_wall_s: 30}\n";
  }

  private static Set<String> parameters(List<String> texts) {
    Set<String> names = new TreeSet<>();
    for (String text : texts) {
      Matcher declared = DECLARED.matcher(text);
      while (declared.find()) {
        names.add(declared.group(1));
      }
    }
    return names;
  }

  /** What each topic is connected to, as {@code activity.yaml} writes it. */
  private Map<String, String> topics(NodeSources sources, List<String> notes) {
    Map<String, List<Endpoint>> byName = new TreeMap<>();
    sources.endpoints().stream()
        .filter(e -> e.kind() == Kind.PUBLISHER || e.kind() == Kind.SUBSCRIPTION)
        .filter(e -> !PASSED_OVER.contains(e.name()))
        .filter(e -> isKnown(e, notes))
        .forEach(e -> byName.computeIfAbsent(e.name(), n -> new ArrayList<>()).add(e));
    Map<String, Set<String>> types = new HashMap<>();
    new NodeSources(given.sources().stream().map(given::text).toList(), Map.of(), given.isCpp())
        .endpoints().stream()
            .filter(e -> e.kind() == Kind.PUBLISHER || e.kind() == Kind.SUBSCRIPTION)
            .forEach(e -> types.computeIfAbsent(e.name(), n -> new HashSet<>()).add(e.type()));
    Set<String> taken = new HashSet<>(TAKEN);
    Map<String, String> topics = new LinkedHashMap<>();
    byName.forEach(
        (topic, endpoints) -> {
          Set<String> ends = new LinkedHashSet<>();
          for (Kind kind : List.of(Kind.SUBSCRIPTION, Kind.PUBLISHER)) {
            if (endpoints.stream().anyMatch(e -> e.kind() == kind)) {
              String end = kind == Kind.SUBSCRIPTION ? "input" : "output";
              ends.add(end + "." + free(identifier(topic), end, taken));
            }
          }
          String shown = ends.size() == 1 ? ends.iterator().next() : ends.toString();
          String type = endpoints.get(0).type().replace("/", "/msg/");
          topics.put(
              topic,
              types.getOrDefault(topic, Set.of()).size() == 1
                  ? shown
                  : "{with: " + shown + ", type: " + type + "}");
        });
    return topics;
  }

  private static boolean isKnown(Endpoint endpoint, List<String> notes) {
    if (TOPIC.matcher(endpoint.name()).matches()) {
      return true;
    }
    notes.add(
        "%s depends on the name of the node; add its full name to topics"
            .formatted(endpoint.name().substring(1)));
    return false;
  }

  private static String identifier(String topic) {
    String plain = topic.replaceAll("^/+", "").replaceAll("\\W+", "_");
    return plain.isEmpty() || Character.isDigit(plain.charAt(0)) ? "topic_" + plain : plain;
  }

  private static String free(String wanted, String end, Set<String> taken) {
    String name = taken.contains(wanted) ? wanted + "_" + end : wanted;
    for (int i = 2; !taken.add(name); i++) {
      name = wanted + "_" + i;
    }
    return name;
  }

  private List<String> services(
      NodeSources sources, Kind kind, FileTree files, List<String> notes) {
    List<String> entries = new ArrayList<>();
    for (Endpoint endpoint : sources.endpoints()) {
      if (endpoint.kind() != kind
          // What the node itself answers is not stubbed.
          || (kind == Kind.CLIENT && serves(sources, endpoint))) {
        continue;
      }
      List<String> candidates =
          Stream.of("srv", "action")
              .map(f -> endpoint.type().replace("/", "/" + f + "/") + "." + f)
              .flatMap(path -> Stream.of(path, "src/" + path))
              .filter(path -> files.contains(path) || installed.contains(path))
              .toList();
      if (candidates.isEmpty()) {
        notes.add(
            "%s: the interface %s is not installed; add its file and an entry under %s"
                .formatted(
                    endpoint.name(),
                    endpoint.type(),
                    kind == Kind.SERVER ? "provided" : "required"));
      } else {
        entries.add(
            "{type: " + candidates.get(0) + ", name: " + YamlScalar.of(endpoint.name()) + "}");
      }
    }
    return entries;
  }

  private static boolean serves(NodeSources sources, Endpoint called) {
    return sources.endpoints().contains(new Endpoint(Kind.SERVER, called.name(), called.type()));
  }

  private static String shown(List<String> entries) {
    return entries.isEmpty()
        ? "[]"
        : entries.stream().map(e -> "\n  - " + e).reduce("", String::concat);
  }

  private static Map<String, String> models(Activity activity) {
    Map<String, String> models = new TreeMap<>();
    boolean hasTopics = !Objects.requireNonNull(activity.profile().ros()).topics().isEmpty();
    List<InterfaceDescription> lifecycle =
        activity.provided().stream().filter(NewNodeActivity::isOfLifecycle).toList();
    if (lifecycle.stream().mapToInt(provided -> provided.methods().size()).sum()
        == LifecycleServices.METHODS.size()) {
      models.put(LIFE_CYCLE, LifecycleProposal.of(LIFE_CYCLE, inputTopics(activity)));
    }
    for (InterfaceDescription provided : activity.provided()) {
      boolean isTopics = provided.name().equals(RosNode.INTERFACE);
      if (lifecycle.contains(provided)) {
        continue;
      }
      if (isTopics && !hasTopics && activity.provided().size() > 1) {
        continue;
      }
      for (Method method : provided.methods()) {
        if (isTopics && !method.name().equals(RosNode.PUBLISH)) {
          continue;
        }
        String model = isTopics ? "Topics" : provided.name() + "_" + method.name();
        models.put(model, ModelProposal.ofNode(provided, method, model));
      }
    }
    return models;
  }

  private static boolean isOfLifecycle(InterfaceDescription provided) {
    return provided.name().equals(LifecycleServices.PACKAGE)
        && provided.methods().stream().allMatch(m -> LifecycleServices.METHODS.contains(m.name()));
  }

  private static List<Method> inputTopics(Activity activity) {
    return activity.provided().stream()
        .filter(provided -> provided.name().equals(RosNode.INTERFACE))
        .flatMap(provided -> provided.methods().stream())
        .filter(method -> !method.name().equals(RosNode.PUBLISH))
        .toList();
  }

  /** Notes about topics whose names are not literals. */
  private List<String> unnamed(List<String> used) {
    List<String> notes = new ArrayList<>();
    for (String path : used) {
      String text = given.text(path);
      long created = CREATION.matcher(text).results().count();
      int named = new NodeSources(List.of(text), Map.of(), given.isCpp()).endpoints().size();
      if (created > named) {
        notes.add(
            "%s/%s creates %d topics, services or actions whose names or types are no literals; the"
                    .formatted(folder(), path, created - named)
                + " notes of a run name them");
      }
    }
    return notes;
  }
}
