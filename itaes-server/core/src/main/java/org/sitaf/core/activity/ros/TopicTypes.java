package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.activity.ros.RosNode.Topic;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * Decides the message type of each topic: the one that {@code activity.yaml} gives, else the one
 * that the node's sources name, else the only one of the device.
 */
final class TopicTypes {
  private static final String TRANSFORMS = "tf2_msgs/TFMessage";

  private final NodeSources sources;
  private final @Nullable WorldDescription world;
  private final String file;
  private final Diagnostics diagnostics;

  TopicTypes(
      NodeSources sources, @Nullable WorldDescription world, String file, Diagnostics diagnostics) {
    this.sources = sources;
    this.world = world;
    this.file = file;
    this.diagnostics = diagnostics;
  }

  /** The topics whose type is known. The others are reported. */
  List<Topic> resolve(List<Topic> topics) {
    List<Topic> resolved = new ArrayList<>();
    for (Topic topic : topics) {
      type(topic).ifPresent(type -> resolved.add(topic.withType(type)));
    }
    return resolved;
  }

  private Optional<String> type(Topic topic) {
    String given = topic.type();
    List<String> found = given == null ? sources.typesOf(topic.name()) : List.of(given);
    if (topic.end(EndKind.WORLD).isPresent()) {
      return ofWorld(topic, found);
    }
    Optional<String> device = topic.end(EndKind.DEVICE);
    if (device.isPresent()) {
      return ofDevice(topic, device.get(), found);
    }
    if (found.size() == 1) {
      return Optional.of(found.get(0));
    }
    return problem(
        topic,
        (found.isEmpty()
                ? unknown()
                : "the node's sources use several message types: " + shown(found))
            + "; write it, such as {with: "
            + RosNodeReader.shown(topic.ends().get(0))
            + ", type: geometry_msgs/msg/Twist}");
  }

  private Optional<String> ofWorld(Topic topic, List<String> found) {
    if (world == null) {
      return problem(topic, "is connected to the world, but activity.yaml has no world");
    }
    if (!found.equals(List.of(TRANSFORMS))) {
      return problem(topic, "the world gives transforms, so only /tf and /tf_static fit");
    }
    return Optional.of(TRANSFORMS);
  }

  private Optional<String> ofDevice(Topic topic, String name, List<String> found) {
    if (world == null) {
      return problem(topic, "is connected to a device, but activity.yaml has no world");
    }
    Optional<Device> device =
        world.devices().stream().filter(d -> d.name().equals(name)).findFirst();
    if (device.isEmpty()) {
      return problem(
          topic,
          world.path()
              + " has no device "
              + name
              + "; it has "
              + String.join(", ", world.devices().stream().map(Device::name).toList()));
    }
    String kind = device.get().kind();
    List<String> fitting = DeviceMessages.of(kind);
    if (fitting.isEmpty()) {
      return problem(
          topic,
          "a device of kind "
              + kind
              + " has no ROS messages; connect the topic to an input or an output");
    }
    List<String> both = found.stream().filter(fitting::contains).toList();
    if (found.isEmpty() && fitting.size() == 1) {
      return Optional.of(fitting.get(0));
    }
    if (both.size() == 1) {
      return Optional.of(both.get(0));
    }
    String fits = "; what fits a device of kind " + kind + ": " + shown(fitting);
    return problem(
        topic,
        found.isEmpty()
            ? unknown()
                + fits
                + "; write {with: device."
                + name
                + ", type: "
                + shown(fitting.subList(0, 1))
                + "}"
            : "has messages of type " + shown(found) + fits);
  }

  private String unknown() {
    List<String> known = sources.topics();
    return "the node's sources do not name the message type of this topic"
        + (known.isEmpty() ? "" : " (they have " + String.join(", ", known) + ")");
  }

  private Optional<String> problem(Topic topic, String message) {
    diagnostics.error(file, topic.line(), "topics." + topic.name(), message);
    return Optional.empty();
  }

  private static String shown(List<String> types) {
    return String.join(", ", types.stream().map(t -> t.replace("/", "/msg/")).toList());
  }
}
