package org.sitaf.core.harness.ros;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.TargetMethod;
import org.sitaf.core.activity.ros.RosElements;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.activity.ros.RosInterfaces;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.activity.ros.RosNode.Topic;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.document.YamlDocument;
import org.sitaf.core.document.YamlMapping;
import org.sitaf.core.harness.python.PythonHarness;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestSuite;

/**
 * Generates the test application of a ROS 2 node: the interface files that it may use, and {@code
 * plan.json}, which says what is published, called and recorded.
 */
public final class RosHarness {
  /** The folder of interface files in the sources of a test application. */
  public static final String INTERFACES = "sitaf_ros_interfaces";

  /** The compiled node of a C++ package, next to the sources of the test application. */
  public static final String LIBRARY = "sitaf_node/libnode.so";

  private static final Pattern PACKAGE_NAME = Pattern.compile("<name>\\s*([\\w-]+)\\s*</name>");
  private static final Pattern SERVICE_FILE = Pattern.compile("(?:.*/)?(srv|action)/(\\w+)\\.\\1");

  /** {@code Interface.Method} or {@code Interface.Method.part}, with the first call as #N. */
  private static final Pattern ANSWER =
      Pattern.compile("([^.#]+\\.[^.#]+)(?:\\.([^.#]+))?(?:#([1-9][0-9]{0,3}))?");

  private static final double NANOS = 1e9;

  private static final String DRIVER =
      """
      \"""Runs the test cases of a ROS 2 node, as plan.json says.\"""

      from pathlib import Path

      from sitaf_runtime.ros.driver import RosTestDriver
      from sitaf_runtime.run import start


      class ConcreteTestDriver(RosTestDriver):
          \"""Publishes the inputs, calls services and records the outputs.\"""

          PLAN = Path(__file__).with_name("plan.json")


      ConcreteTestDriver.load()

      if __name__ == "__main__":
          start(ConcreteTestDriver)
      """;

  private static final String SEQUENCE_DRIVER =
      DRIVER
          .replace("Runs the test cases", "Runs the sequences")
          .replace(
              "from sitaf_runtime.ros.driver import RosTestDriver\n"
                  + "from sitaf_runtime.run import start",
              "from sitaf_runtime.ros.sequence import RosSequenceDriver\n"
                  + "from sitaf_runtime.run import start")
          .replace("RosTestDriver", "RosSequenceDriver")
          .replace(
              "Publishes the inputs, calls services and records the outputs.",
              "Publishes inputs and calls services step by step, and records the outputs of each"
                  + " step.");

  private RosHarness() {}

  /**
   * Generates the sources.
   *
   * @throws InvalidInputException with everything that cannot be tested
   */
  public static FileTree write(Activity activity, TestModel model, TestSuite suite) {
    RosInterfaces ros = Objects.requireNonNull(activity.ros());
    Diagnostics diagnostics = new Diagnostics();
    Map<String, Object> plan = plan(activity, ros, model, suite, diagnostics);
    diagnostics.throwIfErrors();
    String base = model.sequence() == null ? DRIVER : SEQUENCE_DRIVER;
    String driver = new PythonHarness().editableFile(model.name());
    String folder = driver.substring(0, driver.lastIndexOf('/') + 1);
    Map<String, byte[]> files = new HashMap<>();
    files.put("sitaf_harness/__init__.py", bytes("\"\"\"Test applications.\"\"\"\n"));
    files.put(
        folder + "__init__.py", bytes("\"\"\"The test application of one test model.\"\"\"\n"));
    files.put(driver, bytes(base));
    files.put(folder + "plan.json", bytes(JsonText.of(plan)));
    ros.files().forEach((path, content) -> files.put(INTERFACES + "/" + path, content));
    return FileTree.of(files);
  }

  private static Map<String, Object> plan(
      Activity activity,
      RosInterfaces ros,
      TestModel model,
      TestSuite suite,
      Diagnostics diagnostics) {
    SequenceSpec sequence = model.sequence();
    Map<String, Object> plan = new LinkedHashMap<>();
    plan.put("node", node(activity, ros.node(), diagnostics));
    plan.put("life_cycle", activity.profile().component().lifeCycle().name());
    plan.put("topics", topics(ros.node(), activity.world()));
    if (sequence == null) {
      plan.put("target", target(activity, model));
    } else {
      plan.put("steps", RosSteps.of(activity, model, sequence, diagnostics));
    }
    plan.put("settle", model.target().settle().toNanos() / NANOS);
    plan.put("run_for", model.target().runFor().toNanos() / NANOS);
    plan.put("case_sim_s", activity.profile().limits().caseSimulation().toNanos() / NANOS);
    plan.put("world", activity.world() != null);
    plan.put("settings", settings(suite.parameters()));
    if (sequence == null) {
      plan.put(
          "inputs",
          inputs(
              suite.parameters().stream()
                  .filter(p -> p.kind() == InputKind.TDI)
                  .map(CaseParameter::name)
                  .toList()));
    }
    plan.put("required", required(activity));
    plan.put("answers", answers(suite.parameters()));
    plan.put("parameters", parameters(suite));
    if (sequence == null) {
      plan.put("outputs", outputs(model));
    }
    return plan;
  }

  private static Map<String, Object> node(
      Activity activity, RosNode node, Diagnostics diagnostics) {
    String sources = Objects.requireNonNullElse(activity.profile().component().sources(), "");
    Matcher name =
        PACKAGE_NAME.matcher(activity.files().below(sources).text("package.xml").orElse(""));
    Map<String, Object> entry = new LinkedHashMap<>();
    if (node.isCpp()) {
      entry.put("library", LIBRARY);
    }
    if (node.implementation() == RosImplementation.SYSTEM) {
      entry.put("installed", true);
    }
    entry.put("entry", node.entry());
    entry.put("package", name.find() ? name.group(1) : "");
    entry.put("parameters", node.parameters());
    entry.put("parameter_file", parameterFile(activity, node.parameterFile(), diagnostics));
    entry.put("remap", node.remap());
    entry.put("environment", node.environment());
    entry.put("stdin", node.stdin());
    return entry;
  }

  /** The content of a ROS parameter file; empty if there is none. */
  private static Map<String, Object> parameterFile(
      Activity activity, @Nullable String path, Diagnostics diagnostics) {
    Map<String, Object> content = new LinkedHashMap<>();
    Optional<String> text =
        path == null ? Optional.empty() : activity.files().text(Objects.requireNonNull(path));
    if (text.isPresent()) {
      YamlMapping root = YamlDocument.read(text.get(), Objects.requireNonNull(path), diagnostics);
      root.names().forEach(name -> root.data(name).ifPresent(data -> content.put(name, data)));
    }
    return content;
  }

  private static List<Object> topics(RosNode node, @Nullable WorldDescription world) {
    List<Object> topics = new ArrayList<>();
    for (Topic topic : node.topics()) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("name", topic.name());
      entry.put("type", topic.knownType().replace("/", "/msg/"));
      topic.end(EndKind.INPUT).ifPresent(input -> entry.put("input", input));
      topic.end(EndKind.OUTPUT).ifPresent(output -> entry.put("output", output));
      topic.end(EndKind.WORLD).ifPresent(unused -> entry.put("world", true));
      topic
          .end(EndKind.DEVICE)
          .flatMap(
              name ->
                  world == null
                      ? Optional.empty()
                      : world.devices().stream().filter(d -> d.name().equals(name)).findFirst())
          .ifPresent(
              device -> {
                entry.put("device", device.name());
                entry.put("kind", device.kind());
                entry.put("rate_hz", device.rateHz());
                entry.put("frame", topic.frame() == null ? device.name() : topic.frame());
              });
      topics.add(entry);
    }
    return topics;
  }

  /** What the call of a model publishes or calls. */
  static Map<String, Object> target(Activity activity, TestModel model) {
    TargetMethod target;
    try {
      target = TargetMethod.find(model, activity.provided());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(model.source(), "target: " + e.getMessage());
    }
    Map<String, Object> entry = new LinkedHashMap<>();
    if (target.declaring().name().equals(RosNode.INTERFACE)) {
      entry.put("kind", "publish");
      entry.put(
          "inputs",
          target.method().parameters().stream()
              .map(Parameter::name)
              .filter(
                  name ->
                      Objects.requireNonNull(activity.ros())
                          .node()
                          .topicsWith(EndKind.INPUT)
                          .stream()
                          .anyMatch(t -> t.end(EndKind.INPUT).orElseThrow().equals(name)))
              .toList());
      return entry;
    }
    String method = target.method().name();
    RosNode node = Objects.requireNonNull(activity.ros()).node();
    for (String path : activity.profile().provided()) {
      for (String kind : List.of("srv", "action")) {
        if (path.equals(kind + "/" + method + "." + kind)
            || path.endsWith("/" + kind + "/" + method + "." + kind)) {
          entry.put("kind", kind);
          entry.put("type", target.declaring().name() + "/" + kind + "/" + method);
          entry.put("name", node.services().get(path));
          return entry;
        }
      }
    }
    throw InvalidInputException.of(
        "activity.yaml",
        "provided: a service or an action of a ROS 2 node needs a file such as"
            + " PACKAGE/srv/NAME.srv, not "
            + target.declaring().source());
  }

  /** The parameters of the world, and faults of its devices, among these inputs (TDSD). */
  static List<String> settings(List<CaseParameter> inputs) {
    return inputs.stream()
        .filter(p -> p.kind() == InputKind.TDSD)
        .map(CaseParameter::name)
        .filter(name -> !name.equals(RosElements.CALLBACK_ORDER))
        .toList();
  }

  /** The inputs that are parts of messages and requests, by the names of all inputs. */
  static List<Object> inputs(List<String> names) {
    List<Object> inputs = new ArrayList<>();
    for (String name : names) {
      String root = MemberPath.root(name);
      if (!root.equals(RosNode.PUBLISH) && !root.equals("parameter")) {
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("column", name);
        entry.put("root", root);
        entry.put("path", path(name));
        inputs.add(entry);
      }
    }
    return inputs;
  }

  /** The services and actions that the test answers. */
  private static List<Object> required(Activity activity) {
    RosNode node = Objects.requireNonNull(activity.ros()).node();
    List<Object> required = new ArrayList<>();
    for (String path : activity.profile().required()) {
      Matcher file = SERVICE_FILE.matcher(path);
      for (InterfaceDescription description : activity.required()) {
        if (file.matches() && !description.methodsNamed(file.group(2)).isEmpty()) {
          Map<String, Object> entry = new LinkedHashMap<>();
          entry.put("kind", file.group(1));
          entry.put("type", description.name() + "/" + file.group(1) + "/" + file.group(2));
          entry.put("name", node.services().get(path));
          entry.put("method", description.name() + "." + file.group(2));
          required.add(entry);
        }
      }
    }
    return required;
  }

  /** The answers of required services and actions among these inputs (TDTS). */
  static List<Object> answers(List<CaseParameter> inputs) {
    List<Object> answers = new ArrayList<>();
    for (CaseParameter parameter : inputs) {
      Matcher name = ANSWER.matcher(parameter.name());
      if (parameter.kind() == InputKind.TDTS && name.matches()) {
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("column", parameter.name());
        entry.put("method", name.group(1));
        entry.put("part", name.group(2));
        entry.put("from_call", name.group(3) == null ? 1L : Long.parseLong(name.group(3)));
        answers.add(entry);
      }
    }
    return answers;
  }

  /** Values of parameters of the node, with their types as message fields have them. */
  private static List<Object> parameters(TestSuite suite) {
    List<Object> parameters = new ArrayList<>();
    for (CaseParameter parameter : suite.parameters()) {
      if (parameter.kind() == InputKind.TDI && parameter.name().startsWith(RosElements.PARAMETER)) {
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("column", parameter.name());
        entry.put("type", TypeGrammar.parse(parameter.realType()).type().typeName());
        parameters.add(entry);
      }
    }
    return parameters;
  }

  /** What is recorded of a call. */
  static List<Map<String, Object>> outputs(TestModel model) {
    return model.outputs().stream().map(RosHarness::output).toList();
  }

  private static Map<String, Object> output(OutputElement output) {
    String root = MemberPath.root(output.name());
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", output.name());
    if (output.kind() == OutputKind.OUT && RosElements.isCount(output.name())) {
      entry.put("source", "count");
    } else {
      entry.put("source", output.kind().name().toLowerCase(java.util.Locale.ROOT));
    }
    entry.put("root", root);
    entry.put("path", output.kind() == OutputKind.OBSERVED ? List.of() : path(output.name()));
    return entry;
  }

  private static List<Object> path(String name) {
    List<Object> path = new ArrayList<>();
    for (Step step : MemberPath.steps(name)) {
      path.add(
          step instanceof Step.Member member
              ? (Object) member.name()
              : Integer.valueOf(((Step.Element) step).index()));
    }
    return path;
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
