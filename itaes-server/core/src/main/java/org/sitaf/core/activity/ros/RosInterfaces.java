package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.activity.ros.RosNode.Topic;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * A ROS 2 node with the types of its topics.
 *
 * @param node its topics have a type
 * @param topics the interface {@code topics}, whose methods publish inputs
 * @param outputs out-parameters for the last messages of the node
 * @param lines in-parameters that are lines of the standard input and no topic
 * @param files interface files that the node may use, by {@code PACKAGE/msg/NAME.msg}
 */
public record RosInterfaces(
    RosNode node,
    InterfaceDescription topics,
    List<Parameter> outputs,
    List<Parameter> lines,
    NavigableMap<String, byte[]> files) {
  private static final Pattern SERVICE_FILE =
      Pattern.compile("(?:.*/)?(\\w+)/(?:srv|action)/(\\w+)\\.(?:srv|action)");

  public RosInterfaces {
    Objects.requireNonNull(node);
    Objects.requireNonNull(topics);
    outputs = List.copyOf(outputs);
    lines = List.copyOf(lines);
    files = Collections.unmodifiableNavigableMap(new TreeMap<>(files));
  }

  /**
   * Finds the types of a node's topics.
   *
   * @param node as read
   * @param texts sources of the node
   * @param required files of the services and actions that the node calls
   * @param used interface packages that the activity names elsewhere
   * @param activity interface files of the activity by path
   * @param installed interface files of a ROS 2 release by {@code PACKAGE/msg/NAME.msg}
   * @param world null if there is none
   * @param profile name of {@code activity.yaml} for diagnostics
   */
  public static RosInterfaces resolve(
      RosNode node,
      List<String> texts,
      List<String> required,
      Set<String> used,
      Map<String, byte[]> activity,
      Map<String, byte[]> installed,
      @Nullable WorldDescription world,
      String profile,
      Diagnostics diagnostics) {
    NodeSources sources = new NodeSources(texts, node.remap(), node.isCpp());
    List<Topic> topics =
        new TopicTypes(sources, world, profile, diagnostics).resolve(node.topics());
    Set<String> wanted = new LinkedHashSet<>(used);
    wanted.addAll(sources.packages());
    topics.forEach(t -> wanted.add(t.knownType().substring(0, t.knownType().indexOf('/'))));
    NavigableMap<String, byte[]> files = new InterfacePackages(activity, installed).closure(wanted);
    Map<String, DataType> types = types(topics, files, profile, diagnostics);
    topics = topics.stream().filter(t -> types.containsKey(t.knownType())).toList();

    List<Parameter> inputs = parameters(topics, EndKind.INPUT, Direction.IN, types);
    List<Parameter> outputs = parameters(topics, EndKind.OUTPUT, Direction.OUT, types);
    List<Parameter> lines =
        node.stdin().stream()
            .filter(line -> inputs.stream().noneMatch(p -> p.name().equals(line)))
            .distinct()
            .map(l -> new Parameter(l, new DataType.Scalar(ScalarType.STRING), Direction.IN))
            .toList();
    List<Method> methods = new ArrayList<>();
    methods.add(method(RosNode.PUBLISH, inputs));
    inputs.forEach(input -> methods.add(method(input.name(), List.of(input))));
    return new RosInterfaces(
        node.withTopics(topics)
            .withServices(services(node, required, sources, profile, diagnostics)),
        new InterfaceDescription(RosNode.INTERFACE, methods, profile),
        outputs,
        lines,
        files);
  }

  /** The same node with another implementation of ROS 2. */
  public RosInterfaces with(RosImplementation implementation) {
    return new RosInterfaces(node.with(implementation), topics, outputs, lines, files);
  }

  /** The names of services and actions by file, also of those that only the sources name. */
  private static Map<String, String> services(
      RosNode node,
      List<String> required,
      NodeSources sources,
      String profile,
      Diagnostics diagnostics) {
    Map<String, String> services = new HashMap<>(node.services());
    for (String file : required) {
      if (services.containsKey(file)) {
        continue;
      }
      Matcher parts = SERVICE_FILE.matcher(file);
      List<String> names =
          parts.matches() ? sources.clientsOf(parts.group(1) + "/" + parts.group(2)) : List.of();
      if (names.size() == 1) {
        services.put(file, names.get(0));
      } else {
        diagnostics.error(
            profile,
            0,
            "required",
            file
                + ": the node's sources "
                + (names.isEmpty() ? "do not name this service" : "call several services: " + names)
                + "; write {type: "
                + file
                + ", name: /NAME}");
      }
    }
    return services;
  }

  private static Method method(String name, List<Parameter> inputs) {
    return new Method(name, new DataType.Scalar(ScalarType.VOID), inputs, CallType.BLOCKING, 0);
  }

  private static List<Parameter> parameters(
      List<Topic> topics, EndKind kind, Direction direction, Map<String, DataType> types) {
    return topics.stream()
        .filter(t -> t.end(kind).isPresent())
        .map(
            t ->
                new Parameter(
                    t.end(kind).orElseThrow(),
                    Objects.requireNonNull(types.get(t.knownType())),
                    direction))
        .toList();
  }

  private static Map<String, DataType> types(
      List<Topic> topics,
      NavigableMap<String, byte[]> files,
      String profile,
      Diagnostics diagnostics) {
    Set<String> requested = new LinkedHashSet<>();
    for (Topic topic : topics) {
      String type = topic.knownType();
      String path = type.replace("/", "/msg/") + ".msg";
      if (files.containsKey(path)) {
        requested.add(path);
      } else {
        diagnostics.error(
            profile,
            topic.line(),
            "topics." + topic.name(),
            "the message type "
                + type.replace("/", "/msg/")
                + " is neither in the activity nor in the installed interface packages of ROS 2;"
                + " add "
                + path
                + " to the activity");
      }
    }
    ImportResult result = InterfaceFiles.read(SourceFiles.of("", files, List.copyOf(requested)));
    result.diagnostics().stream()
        .filter(d -> requested.contains(d.file()))
        .forEach(d -> diagnostics.addAll(List.of(d)));
    Map<String, DataType> types = new HashMap<>();
    result.types().forEach(type -> types.put(type.typeName(), type));
    return types;
  }

  /** All provided interfaces: the topics, and the given ones, with the outputs of the node. */
  public List<InterfaceDescription> provided(List<InterfaceDescription> services) {
    List<InterfaceDescription> provided = new ArrayList<>();
    provided.add(withOutputs(topics));
    services.forEach(service -> provided.add(withOutputs(service)));
    return provided;
  }

  private InterfaceDescription withOutputs(InterfaceDescription description) {
    List<Method> methods = new ArrayList<>();
    for (Method method : description.methods()) {
      List<Parameter> parameters = new ArrayList<>(method.parameters());
      for (List<Parameter> more : List.of(lines, outputs)) {
        more.stream()
            .filter(p -> parameters.stream().noneMatch(other -> other.name().equals(p.name())))
            .forEach(parameters::add);
      }
      methods.add(
          new Method(
              method.name(),
              method.returnType(),
              parameters,
              method.callType(),
              method.raises(),
              method.line()));
    }
    return new InterfaceDescription(
        description.name(), methods, description.source(), description.constants());
  }

  /**
   * The messages of the node as calls of the interface {@code topics}: their members, and {@code t}
   * in seconds.
   */
  public InterfaceDescription messages() {
    return new InterfaceDescription(
        RosNode.INTERFACE,
        outputs.stream()
            .map(
                output -> {
                  List<Parameter> members = new ArrayList<>();
                  if (output.type() instanceof DataType.Struct struct) {
                    struct
                        .members()
                        .forEach(m -> members.add(new Parameter(m.name(), m.type(), Direction.IN)));
                  }
                  members.add(
                      new Parameter("t", new DataType.Scalar(ScalarType.DOUBLE), Direction.IN));
                  return method(output.name(), members);
                })
            .toList(),
        topics.source());
  }
}
