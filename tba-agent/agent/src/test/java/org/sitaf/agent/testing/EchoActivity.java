package org.sitaf.agent.testing;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * A test application of a component that should return its argument, with the cases 1, 2, 3 and so
 * on. Its driver is written by hand and follows the protocol of the executor, so that the component
 * may do anything.
 */
public final class EchoActivity {
  private final Map<String, byte[]> files = new HashMap<>();
  private String language = "java";
  private String componentClass = "demo.Component";
  private String limits = "{case_wall_s: 10, case_sim_s: 60, memory_mb: 128}";
  private String extra = "";
  private int cases = 5;
  private String postConditions = "";
  private String relations = "";
  private final String harness = resource("ScriptedHarness.java");

  /** The component's class with the given body of {@code int echo(int value) throws Exception}. */
  public static EchoActivity withBody(String body) {
    return withComponent(
        """
        package demo;

        public class Component {
          public int echo(int value) throws Exception {
            %s
          }
        }
        """
            .formatted(body));
  }

  /** The complete source of the component. */
  public static EchoActivity withComponent(String source) {
    EchoActivity activity = new EchoActivity();
    activity.file("component/demo/Component.java", source);
    return activity;
  }

  /** A class in C++; its files are added by {@link #file} below {@code component/}. */
  public static EchoActivity inCpp(String className) {
    return in("cpp", className);
  }

  /** A class in Python; its files are added by {@link #file} below {@code component/}. */
  public static EchoActivity inPython(String className) {
    return in("python", className);
  }

  private static EchoActivity in(String language, String className) {
    EchoActivity activity = new EchoActivity().language(language);
    activity.componentClass = className;
    return activity.profileLine("harness: " + language);
  }

  public EchoActivity language(String name) {
    language = name;
    return this;
  }

  public EchoActivity cases(int number) {
    cases = number;
    return this;
  }

  public EchoActivity caseWallSeconds(double seconds) {
    limits = "{case_wall_s: " + seconds + ", case_sim_s: 60, memory_mb: 128}";
    return this;
  }

  public EchoActivity profileLine(String line) {
    extra += line + "\n";
    return this;
  }

  /** Adds a CEL condition to every case; must not contain characters that XML escapes. */
  public EchoActivity postCondition(String condition) {
    postConditions += "<post_condition>" + condition + "</post_condition>";
    return this;
  }

  /** Adds a relation over {@code Value}; must not contain characters that XML escapes. */
  public EchoActivity relation(String name, String change, String holds) {
    relations +=
        "<relation name=\"%s\"><change name=\"Value\">%s</change><holds>%s</holds></relation>"
            .formatted(name, change, holds);
    return this;
  }

  public EchoActivity file(String path, String content) {
    return file(path, content.getBytes(StandardCharsets.UTF_8));
  }

  public EchoActivity file(String path, byte[] content) {
    files.put(path, content);
    return this;
  }

  /** Uses the driver that SITAF generates, with the real runtime. */
  public TestApplication generated() {
    TestApplication scripted = application();
    return InterfaceTestApplicationGenerator.generate(
        scripted.activity(), scripted.model(), scripted.suite());
  }

  public TestApplication application() {
    Map<String, byte[]> tree = new HashMap<>(files);
    tree.put("activity.yaml", profile().getBytes(StandardCharsets.UTF_8));
    tree.put("Echo.xml", model().getBytes(StandardCharsets.UTF_8));
    tree.put("EchoService.xml", resource("EchoService.xml").getBytes(StandardCharsets.UTF_8));
    Activity activity = Activity.read(FileTree.of(tree));
    TestModel model = activity.model("Echo").orElseThrow();
    return new TestApplication(
        activity,
        model,
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite(),
        FileTree.of(
            Map.of(
                "sitaf/harness/echo/ScriptedHarness.java",
                harness.getBytes(StandardCharsets.UTF_8))),
        "sitaf.harness.echo.ScriptedHarness");
  }

  private String profile() {
    return """
    name: echo
    description: Returns what it is given
    component:
      language: %s
      sources: component/
      class: %s
    provided: [EchoService.xml]
    models: [Echo.xml]
    limits: %s
    %s\
    """
        .formatted(language, componentClass, limits, extra);
  }

  private String model() {
    String values =
        IntStream.rangeClosed(1, cases)
            .mapToObj(value -> "<value>" + value + "</value>")
            .collect(Collectors.joining());
    return resource("Echo.xml")
        .replace("@VALUES@", values)
        .replace(
            "  <order_of",
            list("post_condition_spec_list", postConditions)
                + list("relation_list", relations)
                + "  <order_of");
  }

  private static String list(String element, String content) {
    return content.isEmpty() ? "" : "  <" + element + ">" + content + "</" + element + ">\n";
  }

  private static String resource(String name) {
    try (InputStream stream =
        Objects.requireNonNull(EchoActivity.class.getResourceAsStream("/echo/" + name))) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  /** The toolchains of this machine, with the runtimes that the Maven build copied. */
  public static Toolchains toolchains() {
    return new Toolchains(places());
  }

  /** The runtimes that the Maven build copied, and a cache shared by all tests. */
  public static ToolchainPlaces places() {
    Path runtimes =
        Path.of(
            Objects.requireNonNull(
                System.getProperty("sitaf.runtimes"), "run the tests through Maven"));
    return new ToolchainPlaces(runtimes, runtimes.resolveSibling("test-cache"));
  }

  /** This machine, without a simulator. */
  public static BuildSettings settings() {
    return settings(Sandbox.none());
  }

  /** This machine, without a simulator. */
  public static BuildSettings settings(Sandbox sandbox) {
    return new BuildSettings(Simulator.none(), toolchains(), sandbox, true, "tester 1");
  }
}
