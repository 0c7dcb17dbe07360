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
    String subject,
    String model,
    String description,
    String component,
    String superCall,
    String simulation,
    String stubbing,
    String newComponent,
    String methodUnderTest,
    String callDeclaration,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    String call,
    boolean runOn,
    boolean periodic,
    boolean nonblocking,
    String pendingType,
    boolean returns,
    String expression,
    String outcome,
    List<String> outputs) {

  static TestDriverView of(JavaPlan plan) {
    return new TestDriverView(
        plan.packageName(),
        imports(plan),
        JavaText.comment(subject(plan)),
        JavaText.comment(plan.modelName()),
        JavaText.comment(plan.description()),
        plan.component(),
        superCall(plan),
        plan.world() == null ? "" : "run.simulation()",
        plan.stubs().isEmpty() ? "" : "run.stubbing()",
        JavaText.call("return", "newComponent", newComponentArguments(plan)),
        methodUnderTest(plan),
        callDeclaration(plan),
        reads(plan),
        JavaText.call("", "simulationControl.prepare", settings(plan)),
        JavaText.call(
            "", "testStub.prepare", plan.answers().stream().map(Answered::local).toList()),
        watches(plan),
        call(plan),
        SimulationControlView.runsOn(plan),
        plan.period() != null,
        plan.nonblocking(),
        pendingType(plan),
        plan.returns() != null,
        expression(plan),
        outcome(plan),
        plan.outputs().stream().map(TestDriverView::output).toList());
  }

  /**
   * The declaration of the method that makes the call; declared by the driver and implemented by
   * the concrete driver.
   */
  static String callDeclaration(JavaPlan plan) {
    List<String> parameters = new ArrayList<>();
    parameters.add(plan.component() + " component");
    plan.arguments().forEach(a -> parameters.add(a.parameter()));
    return JavaText.declaration(
        plan.returnName() + " " + plan.callName(), parameters, " throws Exception");
  }

  static String call(JavaPlan plan) {
    return JavaText.call(
        plan.returns() == null ? "" : plan.returnName() + " returned =",
        plan.callName(),
        callArguments(plan));
  }

  static String outcome(JavaPlan plan) {
    return plan.returns() == null
        ? "pending.outcome();"
        : plan.returnName() + " returned = pending.outcome();";
  }

  static String methodUnderTest(JavaPlan plan) {
    return JavaText.comment(plan.interfaceName() + "." + plan.method());
  }

  /** What the driver tests: a method, or sequences of an interface. */
  static String subject(JavaPlan plan) {
    return plan.isSequence()
        ? "sequences of " + plan.interfaceName()
        : plan.interfaceName() + "." + plan.method();
  }

  static String superCall(JavaPlan plan) {
    return JavaText.call(
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

  /** The type of the result of a non-blocking call, which is collected after time has passed. */
  static String pendingType(JavaPlan plan) {
    JavaType returns = plan.returns();
    return returns == null ? "Void" : returns.boxed();
  }

  /** The call as an expression. */
  static String expression(JavaPlan plan) {
    return plan.callName() + "(" + String.join(", ", callArguments(plan)) + ")";
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
                argument.parameter() + " =",
                "new Out<>",
                value == null ? List.of() : List.of(value)));
      } else if (value != null) {
        reads.add(
            value.startsWith("testCase.")
                ? read(argument.type(), argument.local(), argument.name())
                : argument.parameter() + " = " + value + ";");
      }
    }
    if (plan.world() != null) {
      plan.world()
          .settings()
          .forEach(
              s ->
                  reads.add(
                      JavaText.call(
                          "double " + s.local() + " =",
                          "testCase.doubleValue",
                          List.of(JavaText.string(s.name())))));
    }
    for (Answered answer : plan.answers()) {
      reads.add(
          JavaText.call(
              "Answers<" + answer.boxed() + "> " + answer.local() + " =",
              "testCase.answers",
              List.of(JavaText.string(answer.column()), answer.boxed() + ".class", answer.zero())));
    }
    return reads;
  }

  private static String read(JavaType type, String local, String column) {
    return JavaText.call(
        type.name() + " " + local + " =", "testCase." + type.accessor(), type.reading(column));
  }

  /** Records the output data ports that trajectory conditions use. */
  static List<String> watches(JavaPlan plan) {
    return plan.watched().stream()
        .map(
            port ->
                JavaText.call(
                    "",
                    "watch",
                    List.of(JavaText.string(port.name()), "() -> " + port.expression())))
        .toList();
  }

  static String output(Output output) {
    String name = JavaText.string(output.name());
    if (output.expression() == null) {
      return JavaText.call("", "result.recordReturn", List.of(name));
    }
    return JavaText.call(
        "",
        output.part() ? "result.recordPart" : "result.record",
        List.of(name, output.expression()));
  }
}
