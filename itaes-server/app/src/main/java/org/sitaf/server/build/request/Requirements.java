package org.sitaf.server.build.request;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.build.request.Requirement.Device;
import org.sitaf.server.build.request.Requirement.Label;
import org.sitaf.server.build.request.Requirement.Language;
import org.sitaf.server.build.request.Requirement.Simulation;
import org.sitaf.server.build.request.Requirement.Version;

/** The distinct requirements of a build, in a stable order. */
public record Requirements(List<Requirement> all) {
  private static final String LANGUAGE = "language ";
  private static final String VERSION = "version ";
  private static final String LABEL = "label ";
  private static final String DEVICE = "device ";
  private static final String SIMULATION = "simulation";
  private static final String ANALYSES = "analyses";
  private static final String SEPARATOR = ", ";

  public Requirements {
    all = all.stream().distinct().sorted(Comparator.comparing(Requirements::spelling)).toList();
  }

  /** The requirements of a test application and of the build request. */
  public static Requirements of(TestApplication application, AgentConstraints constraints) {
    ActivityProfile profile = application.activity().profile();
    List<Requirement> requirements = new ArrayList<>();
    requirements.add(new Language(profile.harness().id()));
    requirements.add(new Language(profile.component().language().id()));
    if (profile.reference() != null) {
      requirements.add(new Language(profile.reference().language().id()));
    }
    if (application.activity().rosImplementation().equals(Optional.of(RosImplementation.SYSTEM))) {
      requirements.add(Language.INSTALLED_ROS);
    }
    if (profile.world() != null) {
      requirements.add(new Simulation());
    }
    profile.hardware().stream()
        .filter(DeviceBackend::isReal)
        .forEach(backend -> requirements.add(new Device(backend.device())));
    if (!constraints.toolchain().isEmpty()) {
      requirements.add(new Version(profile.component().language().id(), constraints.toolchain()));
    }
    constraints.labels().forEach(label -> requirements.add(new Label(label)));
    return new Requirements(requirements);
  }

  /** These requirements and another one. */
  public Requirements with(Requirement further) {
    return new Requirements(Stream.concat(all.stream(), Stream.of(further)).toList());
  }

  /** Names of the real devices that the build uses. */
  public Set<String> devices() {
    return all.stream()
        .filter(Device.class::isInstance)
        .map(requirement -> ((Device) requirement).name())
        .collect(Collectors.toUnmodifiableSet());
  }

  /** What a ROS 2 node of the build runs with. */
  public RosImplementation rosImplementation() {
    return all.contains(Language.INSTALLED_ROS)
        ? RosImplementation.SYSTEM
        : RosImplementation.INCLUDED;
  }

  /** Parses the result of {@link #text()}. */
  public static Requirements parse(String text) {
    return new Requirements(
        Stream.of(text.split(SEPARATOR))
            .filter(Predicate.not(String::isEmpty))
            .map(Requirements::parseOne)
            .toList());
  }

  /** Whether an agent meets all requirements. */
  public boolean areMetBy(Capabilities agent) {
    return all.stream().allMatch(r -> r.isMetBy(agent));
  }

  /** The first requirement that none of the agents meets, as words. */
  public Optional<String> metByNone(List<Capabilities> agents) {
    return all.stream()
        .filter(r -> agents.stream().noneMatch(r::isMetBy))
        .map(Requirement::words)
        .findFirst();
  }

  /** The requirements in a sentence. */
  public String words() {
    return String.join(" with ", all.stream().map(Requirement::words).toList());
  }

  /** The text in the database; equal requirements have equal texts. */
  public String text() {
    return String.join(SEPARATOR, all.stream().map(Requirements::spelling).toList());
  }

  private static String spelling(Requirement requirement) {
    if (requirement instanceof Language language) {
      return LANGUAGE + language.name();
    }
    if (requirement instanceof Version version) {
      return VERSION + version.language() + " " + version.version();
    }
    if (requirement instanceof Label label) {
      return LABEL + label.name();
    }
    if (requirement instanceof Device device) {
      return DEVICE + device.name();
    }
    return requirement instanceof Requirement.Analyses ? ANALYSES : SIMULATION;
  }

  private static Requirement parseOne(String text) {
    if (text.startsWith(LANGUAGE)) {
      return new Language(text.substring(LANGUAGE.length()));
    }
    if (text.startsWith(VERSION)) {
      String[] words = text.substring(VERSION.length()).split(" ", 2);
      return new Version(words[0], words[1]);
    }
    if (text.startsWith(LABEL)) {
      return new Label(text.substring(LABEL.length()));
    }
    if (text.startsWith(DEVICE)) {
      return new Device(text.substring(DEVICE.length()));
    }
    if (text.equals(ANALYSES)) {
      return new Requirement.Analyses();
    }
    if (text.equals(SIMULATION)) {
      return new Simulation();
    }
    throw new IllegalArgumentException("'" + text + "' is not a requirement");
  }
}
