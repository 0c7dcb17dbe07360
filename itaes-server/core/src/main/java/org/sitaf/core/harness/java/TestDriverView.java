package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Answered;
import org.sitaf.core.harness.java.plan.JavaPlan.Argument;
import org.sitaf.core.harness.java.plan.JavaPlan.Output;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;

/** The view of the test driver: the five steps of Fig. 10. */
record TestDriverView(
    String packageName,
    SortedSet<String> imports,
    String documentation,
    String component,
    String superCall,
    String simulation,
    String stubbing,
    String newComponent,
    String callDocumentation,
    String callDeclaration,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    String call,
    boolean runOn,
    boolean periodic,
    boolean nonblocking,
    String begin,
    String outcome,
    List<String> outputs) {

  static TestDriverView of(JavaPlan plan) {
    return new TestDriverView(
        plan.packageName(),
        imports(plan),
        documentation(plan),
        plan.component(),
        superCall(plan),
        plan.world() == null ? "" : "run.simulation()",
        plan.stubs().isEmpty() ? "" : "run.stubbing()",
        JavaText.call(4, "return", "newComponent", newComponentArguments(plan)),
        callDocumentation(plan),
        callDeclaration(plan, "abstract ", ";"),
        reads(plan),
        JavaText.call(4, "", "simulationControl.prepare", settings(plan)),
        JavaText.call(
            4, "", "testStub.prepare", plan.answers().stream().map(Answered::local).toList()),
        watches(plan),
        call(plan),
        SimulationControlView.runsOn(plan),
        plan.period() != null,
        plan.nonblocking(),
        begin(plan),
        outcome(plan),
        plan.outputs().stream().map(TestDriverView::output).toList());
  }

  /**
   * The declaration of the method that makes the call; declared by the driver and implemented by
   * the concrete driver.
   */
  static String callDeclaration(JavaPlan plan, String modifiers, String end) {
    List<String> parameters = new ArrayList<>();
    parameters.add(plan.component() + " component");
    plan.arguments().forEach(a -> parameters.add(a.parameter()));
    return JavaText.declaration(
        2, modifiers + plan.returnName() + " " + plan.callName(), parameters, true, end);
  }

  static String call(JavaPlan plan) {
    return JavaText.call(
        4,
        plan.returns() == null ? "" : plan.returnName() + " returned =",
        plan.callName(),
        callArguments(plan));
  }

  static String outcome(JavaPlan plan) {
    return plan.returns() == null
        ? "    pending.outcome();"
        : "    " + plan.returnName() + " returned = pending.outcome();";
  }

  static String callDocumentation(JavaPlan plan) {
    return JavaText.javadoc(
        2,
        List.of(
            "Calls the method under test, "
                + JavaText.comment(plan.interfaceName() + "." + plan.method())
                + ". Only this call is timed."),
        List.of());
  }

  static String superCall(JavaPlan plan) {
    return JavaText.call(
        4,
        "",
        "super",
        Stream.concat(
                Stream.of("run", "LifeCycle." + (plan.suiteLife() ? "SUITE" : "CASE")),
                plan.notHooks().stream().map(JavaText::string))
            .toList());
  }

  private static List<String> callArguments(JavaPlan plan) {
    return Stream.concat(Stream.of("component"), plan.arguments().stream().map(Argument::local))
        .toList();
  }

  /** A non-blocking call: started here; its result is collected after time has passed. */
  static String begin(JavaPlan plan) {
    String call = plan.callName() + "(" + String.join(", ", callArguments(plan)) + ")";
    JavaType returns = plan.returns();
    return returns == null
        ? JavaText.call(
            4,
            "NonblockingCall<Void> pending =",
            "callNonblocking",
            List.of("() -> {\n          " + call + ";\n          return null;\n        }"))
        : JavaText.call(
            4,
            "NonblockingCall<" + returns.boxed() + "> pending =",
            "callNonblocking",
            List.of("() -> " + call));
  }

  private static SortedSet<String> imports(JavaPlan plan) {
    SortedSet<String> imports = new TreeSet<>();
    for (String type : List.of("LifeCycle", "SuiteDriver", "TestRun")) {
      imports.add("org.sitaf.runtime." + type);
    }
    imports.add(
        plan.nonblocking()
            ? "org.sitaf.runtime.component.NonblockingCall"
            : "org.sitaf.runtime.Stopwatch");
    imports.add("org.sitaf.runtime.suite.CaseResult");
    imports.add("org.sitaf.runtime.suite.TestCase");
    addTypesOfCall(plan, imports);
    addTypesOfReads(plan, imports);
    return imports;
  }

  /** Adds the imports of the values that are read from a case. */
  static void addTypesOfReads(JavaPlan plan, SortedSet<String> imports) {
    plan.arguments().forEach(a -> a.reads().forEach(r -> imports.addAll(r.type().imports())));
    if (!plan.answers().isEmpty()) {
      imports.add("org.sitaf.runtime.suite.Answers");
    }
    plan.answers().forEach(a -> imports.addAll(a.imports()));
    // Nested structs that are not imported otherwise.
    plan.arguments().stream()
        .filter(a -> !a.reads().isEmpty())
        .forEach(
            a ->
                plan.types().stream()
                    .filter(t -> a.value().matches(".*\\b" + t.name() + "\\b.*"))
                    .forEach(t -> imports.add(JavaType.INTERFACES + "." + t.name())));
  }

  /** Adds the imports of the call's declaration. */
  static void addTypesOfCall(JavaPlan plan, SortedSet<String> imports) {
    if (plan.componentImport() != null) {
      imports.add(plan.componentImport());
    }
    if (plan.arguments().stream().anyMatch(a -> a.direction() != Direction.IN)) {
      imports.add("org.sitaf.runtime.Out");
    }
    if (plan.returns() != null) {
      imports.addAll(plan.returns().imports());
    }
    plan.arguments().forEach(a -> imports.addAll(a.type().imports()));
  }

  static String documentation(JavaPlan plan) {
    List<String> paragraphs = new ArrayList<>();
    paragraphs.add(
        "Test driver (TD) of "
            + JavaText.comment(
                plan.isSequence()
                    ? "sequences of " + plan.interfaceName()
                    : plan.interfaceName() + "." + plan.method())
            + ": runs the cases of the test model "
            + JavaText.comment(plan.modelName())
            + ".");
    if (!plan.description().isBlank()) {
      paragraphs.add(JavaText.comment(plan.description()));
    }
    return JavaText.javadoc(0, paragraphs, List.of());
  }

  static List<String> newComponentArguments(JavaPlan plan) {
    List<String> arguments = new ArrayList<>();
    arguments.add(plan.component() + ".class");
    plan.stubs().forEach(s -> arguments.add("testStub." + s.field()));
    return arguments;
  }

  static List<String> settings(JavaPlan plan) {
    World world = plan.world();
    return world == null ? List.of() : world.settings().stream().map(World.Setting::local).toList();
  }

  static List<String> reads(JavaPlan plan) {
    List<String> reads = new ArrayList<>();
    for (Argument argument : plan.arguments()) {
      argument.reads().forEach(r -> reads.add(read(r.type(), r.local(), r.column())));
      String value = argument.value();
      if (argument.direction() != Direction.IN) {
        reads.add(
            JavaText.call(
                4,
                argument.parameter() + " =",
                "new Out<>",
                value == null ? List.of() : List.of(value)));
      } else if (value != null) {
        reads.add(
            value.startsWith("testCase.")
                ? read(argument.type(), argument.local(), argument.name())
                : assigned(argument.parameter(), value));
      }
    }
    if (plan.world() != null) {
      plan.world()
          .settings()
          .forEach(
              s ->
                  reads.add(
                      JavaText.call(
                          4,
                          "double " + s.local() + " =",
                          "testCase.doubleValue",
                          List.of(JavaText.string(s.name())))));
    }
    for (Answered answer : plan.answers()) {
      reads.add(
          JavaText.call(
              4,
              "Answers<" + answer.boxed() + "> " + answer.local() + " =",
              "testCase.answers",
              List.of(JavaText.string(answer.column()), answer.boxed() + ".class", answer.zero())));
    }
    return reads;
  }

  private static String assigned(String declaration, String value) {
    int open = value.indexOf('(');
    boolean call = open > 0 && value.endsWith(")") && !value.substring(0, open).contains("[");
    return call
        ? JavaText.call(
            4,
            declaration + " =",
            value.substring(0, open),
            List.of(value.substring(open + 1, value.length() - 1)))
        : "    " + declaration + " = " + value + ";";
  }

  private static String read(JavaType type, String local, String column) {
    return JavaText.call(
        4, type.name() + " " + local + " =", "testCase." + type.accessor(), type.reading(column));
  }

  /** Records the output data ports that trajectory conditions use. */
  static List<String> watches(JavaPlan plan) {
    return plan.watched().stream()
        .map(
            port ->
                JavaText.call(
                    4,
                    "",
                    "watch",
                    List.of(JavaText.string(port.name()), "() -> " + port.expression())))
        .toList();
  }

  static String output(Output output) {
    String name = JavaText.string(output.name());
    if (output.expression() == null) {
      return JavaText.call(4, "", "result.recordReturn", List.of(name));
    }
    return JavaText.call(
        4,
        "",
        output.part() ? "result.recordPart" : "result.record",
        List.of(name, output.expression()));
  }
}
