package org.sitaf.core.activity;

import java.time.Duration;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.activity.ActivityProfile.Sanitizer;
import org.sitaf.core.activity.hardware.HardwareReader;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.activity.ros.RosNodeReader;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.YamlDocument;
import org.sitaf.core.document.YamlMapping;
import org.sitaf.core.timing.Timing;

/** Reads {@code activity.yaml}. */
final class ProfileReader {
  private static final String MUST_BE = "must be java, cpp, python, ros2-python or ros2-cpp, not '";

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,99}");
  private static final Set<String> ENTRIES =
      Set.of(
          "name",
          "description",
          "component",
          "reference",
          "provided",
          "required",
          "libraries",
          "idl_includes",
          "harness",
          "world",
          "models",
          "parallel",
          "sanitize",
          "timing",
          "limits",
          "hardware",
          "topics");
  private static final Set<String> COMPONENT_ENTRIES =
      Set.of(
          "language",
          "sources",
          "library",
          "headers",
          "header",
          "package",
          "class",
          "adapter",
          "profile",
          "properties",
          "life_cycle",
          "execution",
          "period_ms",
          "before");

  private static final String COMPONENT = "component";
  private static final String REFERENCE = "reference";

  /** Why the calls of a component that lives as long as the suite cannot be repeated. */
  static final String TIMING_NEEDS_CASE =
      "needs life_cycle: case, because a component with life_cycle: suite keeps its state, so that"
          + " a repeated call is another case; write life_cycle: case, or remove timing";

  private ProfileReader() {}

  /** Reads a profile. Problems are added to the diagnostics. */
  static ActivityProfile read(String text, String file, Diagnostics diagnostics) {
    YamlMapping root = YamlDocument.read(text, file, diagnostics);
    root.allowOnly(ENTRIES);
    String name = root.requiredText("name");
    if (!name.isEmpty() && !NAME.matcher(name).matches()) {
      root.problem(
          "name",
          "'"
              + name
              + "' is not a name; use letters, digits, '.', '_' and '-', at most 100 characters");
    }
    Component component = component(root, COMPONENT);
    Component reference = root.has(REFERENCE) ? component(root, REFERENCE) : null;
    RosNode node = node(root);
    if (node == null && root.has("topics")) {
      root.problem(
          "topics", "is only allowed with component.language: ros2-python or ros2-cpp; remove it");
    }
    if (node != null && reference != null) {
      root.problem(REFERENCE, "is not yet available for ROS 2 nodes; remove it");
    }
    if (node != null && root.has("harness")) {
      root.problem("harness", "has no effect for a ROS 2 node; remove it");
    }
    Map<String, String> services = new HashMap<>();
    List<String> provided = interfaces(root, "provided", node != null, services);
    if (node != null) {
      provided.stream()
          .filter(path -> !services.containsKey(path))
          .forEach(
              path ->
                  root.problem(
                      "provided",
                      "the service or action needs a name; write {type: "
                          + path
                          + ", name: /NAME}"));
    }
    List<String> required = interfaces(root, "required", node != null, services);
    Language harness =
        root.text("harness")
            .flatMap(value -> language(root, "harness", value))
            .orElse(component.language());
    // Models are optional: a new activity has only a component and its interfaces.
    if (provided.isEmpty() && node == null) {
      root.problem("provided", "must list at least one file");
    }
    return new ActivityProfile(
        name,
        root.text("description").orElse(""),
        component,
        reference,
        provided,
        required,
        root.texts("libraries"),
        root.texts("idl_includes"),
        harness,
        root.text("world").orElse(null),
        root.texts("models"),
        root.booleanValue("parallel").orElse(false),
        sanitizers(root, component, harness, node),
        timing(root, component),
        node == null ? null : node.withServices(services),
        HardwareReader.read(root),
        root.mapping("limits").map(ProfileReader::limits).orElse(Limits.DEFAULT));
  }

  /** The ROS 2 node of the component; null for any other component. */
  private static @Nullable RosNode node(YamlMapping root) {
    Optional<YamlMapping> component = root.mapping(COMPONENT).filter(ProfileReader::isRosNode);
    return component.isEmpty() ? null : RosNodeReader.read(root, component.get());
  }

  private static boolean isRosNode(YamlMapping component) {
    return component.text("language").orElse("").toLowerCase(Locale.ROOT).startsWith("ros2");
  }

  /**
   * The interface files of an entry.
   *
   * @param named whether an item can be a mapping of type and name
   * @param names receives the names of services and actions by interface file
   */
  private static List<String> interfaces(
      YamlMapping root, String entry, boolean named, Map<String, String> names) {
    if (!named) {
      return root.texts(entry);
    }
    List<String> files = new java.util.ArrayList<>();
    for (YamlMapping.Item item : root.items(entry)) {
      YamlMapping table = item.mapping();
      if (item.text() != null) {
        files.add(item.text());
      } else if (table != null) {
        table.allowOnly(Set.of("type", "name"));
        String type = table.requiredText("type");
        files.add(type);
        table.text("name").ifPresent(name -> names.put(type, name));
      }
    }
    if (Set.copyOf(files).size() < files.size()) {
      root.problem(
          entry, "lists an interface file twice; test each of these services in its own activity");
    }
    return files;
  }

  /** The component of a ROS 2 node. */
  private static Component rosNode(YamlMapping entry) {
    String language = entry.text("language").orElse("").toLowerCase(Locale.ROOT);
    if (!language.equals("ros2-cpp") && !language.equals("ros2-python")) {
      entry.problem("language", MUST_BE + language + "'");
    }
    // The test application of a node is in Python for both languages.
    return new Component(
        Language.PYTHON,
        entry.requiredText("sources"),
        null,
        null,
        null,
        null,
        entry.text("class").or(() -> entry.text("main")).orElse(""),
        null,
        null,
        Map.of(),
        lifeCycle(entry),
        null,
        List.of());
  }

  private static Component component(YamlMapping root, String name) {
    Optional<YamlMapping> found = root.mapping(name);
    if (found.isEmpty()) {
      root.problem(
          name,
          "must describe the "
              + (name.equals(REFERENCE) ? "second implementation" : "component under test")
              + ": language, sources and class");
      return new Component(
          Language.JAVA,
          "",
          null,
          null,
          null,
          null,
          "",
          null,
          null,
          Map.of(),
          LifeCycle.CASE,
          null,
          List.of());
    }
    YamlMapping entry = found.get();
    if (isRosNode(entry)) {
      return rosNode(entry);
    }
    Set<String> known = new HashSet<>(COMPONENT_ENTRIES);
    known.addAll(CppBuildReader.ENTRIES);
    entry.allowOnly(known);
    long origins =
        List.of("sources", "library", "package", "cmake").stream().filter(entry::has).count();
    if (origins != 1) {
      entry.problem(
          "sources",
          "the component needs exactly one of sources, library, package and, in C++, cmake");
    }
    Map<String, String> properties = new HashMap<>();
    entry
        .mapping("properties")
        .ifPresent(
            all -> all.names().forEach(n -> all.text(n).ifPresent(v -> properties.put(n, v))));
    Language language =
        language(entry, "language", entry.requiredText("language")).orElse(Language.JAVA);
    return new Component(
        language,
        entry.text("sources").or(() -> CppBuildReader.cmakeProject(entry)).orElse(null),
        entry.text("library").orElse(null),
        entry.text("headers").orElse(null),
        entry.text("header").orElse(null),
        entry.text("package").orElse(null),
        entry.requiredText("class"),
        entry.text("adapter").orElse(null),
        entry.text("profile").orElse(null),
        properties,
        lifeCycle(entry),
        period(entry),
        entry.texts("before"),
        CppBuildReader.read(entry, language));
  }

  private static Optional<Language> language(YamlMapping entry, String name, String text) {
    for (Language language : Language.values()) {
      if (language.id().equals(text.toLowerCase(Locale.ROOT))) {
        return Optional.of(language);
      }
    }
    if (entry.has(name)) {
      entry.problem(name, MUST_BE + text + "'");
    }
    return Optional.empty();
  }

  private static Set<Sanitizer> sanitizers(
      YamlMapping root, Component component, Language harness, @Nullable RosNode node) {
    Set<Sanitizer> found = EnumSet.noneOf(Sanitizer.class);
    for (String name : root.texts("sanitize")) {
      Arrays.stream(Sanitizer.values())
          .filter(sanitizer -> sanitizer.id().equals(name))
          .findFirst()
          .ifPresentOrElse(
              found::add,
              () ->
                  root.problem(
                      "sanitize",
                      "must list address, undefined and thread only, not '" + name + "'"));
    }
    if (found.containsAll(Set.of(Sanitizer.ADDRESS, Sanitizer.THREAD))) {
      root.problem(
          "sanitize", "cannot list both address and thread, because a compiler adds only one");
    }
    if (node != null && node.isCpp()) {
      if (found.contains(Sanitizer.THREAD)) {
        root.problem(
            "sanitize",
            "thread finds nothing in a ROS 2 node, whose threads run one at a time; remove it");
      }
      return found;
    }
    if (!found.isEmpty() && (component.language() != Language.CPP || harness != Language.CPP)) {
      root.problem("sanitize", "is only allowed for components in C++; remove it");
    } else if (!found.isEmpty() && component.sources() == null) {
      root.problem(
          "sanitize",
          "has no effect on a compiled library; give the sources of the component, or remove it");
    }
    return found;
  }

  private static @Nullable Timing timing(YamlMapping root, Component component) {
    Optional<YamlMapping> found = root.mapping("timing");
    if (found.isEmpty()) {
      return null;
    }
    YamlMapping entry = found.get();
    entry.allowOnly(Set.of("warm_up", "repeat"));
    if (component.lifeCycle() == LifeCycle.SUITE) {
      root.problem("timing", TIMING_NEEDS_CASE);
    }
    return new Timing(
        calls(entry, "warm_up", 0, Timing.MAX_WARM_UP, Timing.DEFAULT_WARM_UP),
        calls(entry, "repeat", 1, Timing.MAX_REPEAT, Timing.DEFAULT_REPEAT),
        root.line("timing"));
  }

  private static int calls(YamlMapping entry, String name, int min, int max, int otherwise) {
    double number = entry.number(name).orElse((double) otherwise);
    if (number != Math.rint(number) || number < min || number > max) {
      entry.problem(name, "must be a whole number from %d to %d".formatted(min, max));
      return otherwise;
    }
    return (int) number;
  }

  private static LifeCycle lifeCycle(YamlMapping entry) {
    return switch (entry.text("life_cycle").orElse("case")) {
      case "case" -> LifeCycle.CASE;
      case "suite" -> LifeCycle.SUITE;
      default -> {
        entry.problem("life_cycle", "must be case or suite");
        yield LifeCycle.CASE;
      }
    };
  }

  private static @Nullable Duration period(YamlMapping entry) {
    Optional<Double> periodMs = entry.number("period_ms");
    switch (entry.text("execution").orElse("passive")) {
      case "passive" -> {
        if (periodMs.isPresent()) {
          entry.problem("period_ms", "is only allowed with execution: periodic");
        }
        return null;
      }
      case "periodic" -> {
        if (periodMs.isEmpty() || periodMs.get() <= 0) {
          entry.problem(
              "period_ms", "execution: periodic needs a period in milliseconds, greater than 0");
          return null;
        }
        return Duration.ofNanos(Math.round(periodMs.get() * 1e6));
      }
      default -> {
        entry.problem("execution", "must be passive or periodic");
        return null;
      }
    }
  }

  private static Limits limits(YamlMapping entry) {
    entry.allowOnly(Set.of("case_wall_s", "case_sim_s", "memory_mb", "prepare_s", "jitter_ms"));
    return new Limits(
        seconds(entry, "case_wall_s", Limits.DEFAULT.caseWall()),
        seconds(entry, "case_sim_s", Limits.DEFAULT.caseSimulation()),
        (int) positive(entry, "memory_mb", Limits.DEFAULT.memoryMiB()),
        seconds(entry, "prepare_s", Limits.DEFAULT.preparation()),
        Duration.ofNanos(
            Math.round(
                positive(entry, "jitter_ms", Limits.DEFAULT.jitter().toNanos() / 1e6) * 1e6)));
  }

  private static Duration seconds(YamlMapping entry, String name, Duration otherwise) {
    return Duration.ofMillis(Math.round(positive(entry, name, otherwise.toMillis() / 1e3) * 1e3));
  }

  private static double positive(YamlMapping entry, String name, double otherwise) {
    double number = entry.number(name).orElse(otherwise);
    if (number < 0.001 || number > 1e6) {
      entry.problem(name, "must be between 0.001 and 1000000");
      return otherwise;
    }
    return number;
  }
}
