package org.sitaf.core.activity.ros;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * What {@code activity.yaml} says about a component that is a ROS 2 node.
 *
 * @param isCpp whether it is written in C++, otherwise in Python
 * @param entry the node's class, or with {@code isMain} its function {@code module:function} or a
 *     file relative to the sources
 * @param packages names of pkg-config that a C++ node is linked with
 * @param parameters overrides of declared parameters: Boolean, Long, Double, String or a List of
 *     these
 * @param parameterFile path of a ROS parameter file in the activity; null if there is none
 * @param remap names of the node and what they are replaced by
 * @param environment variables that the node sees
 * @param stdin inputs of the case that are the lines of its standard input
 * @param topics in the order of the document
 * @param services names of the provided services and actions by their interface file
 * @param implementation what it runs with
 */
public record RosNode(
    boolean isCpp,
    String entry,
    boolean isMain,
    List<String> packages,
    Map<String, Object> parameters,
    @Nullable String parameterFile,
    Map<String, String> remap,
    Map<String, String> environment,
    List<String> stdin,
    List<Topic> topics,
    Map<String, String> services,
    RosImplementation implementation) {
  /** The name of the generated interface. */
  public static final String INTERFACE = "topics";

  /** The method that publishes every input. */
  public static final String PUBLISH = "publish";

  public RosNode {
    Objects.requireNonNull(entry);
    Objects.requireNonNull(implementation);
    packages = List.copyOf(packages);
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    remap = Collections.unmodifiableMap(new TreeMap<>(remap));
    environment = Collections.unmodifiableMap(new TreeMap<>(environment));
    stdin = List.copyOf(stdin);
    topics = List.copyOf(topics);
    services = Collections.unmodifiableMap(new TreeMap<>(services));
  }

  /**
   * A topic of the node and what it is connected to.
   *
   * @param name with a leading slash
   * @param frame the {@code frame_id} of a device's messages; null for the device's name
   * @param type the message type as {@code package/Name}; null if it is not known yet
   * @param line in {@code activity.yaml}
   */
  public record Topic(
      String name, List<End> ends, @Nullable String frame, @Nullable String type, int line) {
    public Topic {
      Objects.requireNonNull(name);
      ends = List.copyOf(ends);
    }

    Topic withType(String known) {
      return new Topic(name, ends, frame, known, line);
    }

    /** The message type; never called before it is known. */
    public String knownType() {
      return Objects.requireNonNull(type, name);
    }

    /** The name of its end of a kind. */
    public Optional<String> end(EndKind kind) {
      return ends.stream().filter(e -> e.kind() == kind).map(End::name).findFirst();
    }
  }

  /** What a topic is connected to. */
  public enum EndKind {
    /** A device of the world, which sends or takes the messages. */
    DEVICE,
    /** An input of the case, whose messages the test publishes. */
    INPUT,
    /** An output of the case: the messages of the node. */
    OUTPUT,
    /** The transforms of the world. */
    WORLD
  }

  /**
   * One end of a topic.
   *
   * @param name of the device, input or output; empty for the world
   */
  public record End(EndKind kind, String name) {
    public End {
      Objects.requireNonNull(kind);
      Objects.requireNonNull(name);
    }
  }

  /** The topics with an end of a kind. */
  public List<Topic> topicsWith(EndKind kind) {
    return topics.stream().filter(t -> t.end(kind).isPresent()).toList();
  }

  /** A copy with names of services and actions. */
  public RosNode withServices(Map<String, String> names) {
    return copy(topics, names, implementation);
  }

  RosNode withTopics(List<Topic> resolved) {
    return copy(resolved, services, implementation);
  }

  RosNode with(RosImplementation chosen) {
    return copy(topics, services, chosen);
  }

  private RosNode copy(
      List<Topic> newTopics, Map<String, String> newServices, RosImplementation newImplementation) {
    return new RosNode(
        isCpp,
        entry,
        isMain,
        packages,
        parameters,
        parameterFile,
        remap,
        environment,
        stdin,
        newTopics,
        newServices,
        newImplementation);
  }
}
