package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Argument;
import org.sitaf.core.harness.java.plan.JavaPlan.Output;
import org.sitaf.core.harness.java.plan.JavaPlan.StubMethod;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;
import org.sitaf.core.model.Tolerance;

/** What the template of the test driver prints: the five steps of Fig. 10. */
record TestDriverView(
    String packageName,
    SortedSet<String> imports,
    String documentation,
    String component,
    String lifeCycle,
    String simulation,
    String stubbing,
    String newComponent,
    String callDocumentation,
    String callDeclaration,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    String call,
    boolean runOn,
    List<String> outputs) {

  static TestDriverView of(JavaPlan plan) {
    return new TestDriverView(
        plan.packageName(),
        imports(plan),
        documentation(plan),
        plan.component(),
        plan.suiteLife() ? "SUITE" : "CASE",
        plan.world() == null ? "" : "run.simulation()",
        plan.stubs().isEmpty() ? "" : "run.stopwatch()",
        JavaText.call(4, "return", "newComponent", newComponentArguments(plan)),
        JavaText.javadoc(
            2,
            List.of(
                "The call under test, "
                    + JavaText.comment(plan.interfaceName() + "." + plan.method())
                    + "; nothing else is timed."),
            List.of()),
        callDeclaration(plan, "abstract ", ";"),
        reads(plan),
        JavaText.call(4, "", "simulationControl.prepare", settings(plan)),
        JavaText.call(
            4, "", "testStub.prepare", plan.answers().stream().map(StubMethod::field).toList()),
        JavaText.call(
            4,
            plan.returns() == null ? "" : plan.returnName() + " returned =",
            "call",
            Stream.concat(Stream.of("component"), plan.arguments().stream().map(Argument::local))
                .toList()),
        SimulationControlView.runsOn(plan),
        plan.outputs().stream().map(TestDriverView::output).toList());
  }

  /**
   * The head of the method that makes the call, which the driver declares and the concrete driver
   * implements.
   */
  static String callDeclaration(JavaPlan plan, String modifiers, String end) {
    List<String> parameters = new ArrayList<>();
    parameters.add(plan.component() + " component");
    plan.arguments().forEach(a -> parameters.add(a.parameter()));
    return JavaText.declaration(2, modifiers + plan.returnName() + " call", parameters, true, end);
  }

  private static SortedSet<String> imports(JavaPlan plan) {
    SortedSet<String> imports = new TreeSet<>();
    for (String type : List.of("LifeCycle", "Stopwatch", "SuiteDriver", "TestRun")) {
      imports.add("org.sitaf.runtime." + type);
    }
    imports.add("org.sitaf.runtime.suite.CaseResult");
    imports.add("org.sitaf.runtime.suite.TestCase");
    if (plan.outputs().stream().anyMatch(o -> o.tolerance() != null)) {
      imports.add("org.sitaf.runtime.suite.Tolerance");
    }
    addTypesOfCall(plan, imports);
    if (plan.answers().stream().anyMatch(a -> a.returnName().startsWith("BigInteger"))) {
      imports.add("java.math.BigInteger");
    }
    return imports;
  }

  /** What the head of the call needs: the component, out-parameters, wide integers. */
  static void addTypesOfCall(JavaPlan plan, SortedSet<String> imports) {
    if (plan.componentImport() != null) {
      imports.add(plan.componentImport());
    }
    if (plan.arguments().stream().anyMatch(a -> a.direction() != Direction.IN)) {
      imports.add("org.sitaf.runtime.Out");
    }
    boolean wide =
        plan.returnName().startsWith("BigInteger")
            || plan.arguments().stream().anyMatch(a -> a.type().name().startsWith("BigInteger"));
    if (wide) {
      imports.add("java.math.BigInteger");
    }
  }

  private static String documentation(JavaPlan plan) {
    List<String> paragraphs = new ArrayList<>();
    paragraphs.add(
        "Test driver (TD) of "
            + JavaText.comment(plan.interfaceName() + "." + plan.method())
            + ": runs the cases of the test model "
            + JavaText.comment(plan.modelName())
            + ".");
    if (!plan.description().isBlank()) {
      paragraphs.add(JavaText.comment(plan.description()));
    }
    return JavaText.javadoc(0, paragraphs, List.of());
  }

  private static List<String> newComponentArguments(JavaPlan plan) {
    List<String> arguments = new ArrayList<>();
    arguments.add(plan.component() + ".class");
    plan.stubs().forEach(s -> arguments.add("testStub." + s.field()));
    return arguments;
  }

  private static List<String> settings(JavaPlan plan) {
    World world = plan.world();
    return world == null ? List.of() : world.settings().stream().map(World.Setting::local).toList();
  }

  private static List<String> reads(JavaPlan plan) {
    List<String> reads = new ArrayList<>();
    for (Argument argument : plan.arguments()) {
      if (argument.direction() == Direction.IN) {
        reads.add(
            read(
                argument.type().name(),
                argument.local(),
                argument.type().accessor(),
                argument.name()));
      } else if (argument.given()) {
        String value =
            "testCase." + argument.type().accessor() + "(" + JavaText.string(argument.name()) + ")";
        reads.add(JavaText.call(4, argument.parameter() + " =", "new Out<>", List.of(value)));
      } else {
        reads.add(JavaText.call(4, argument.parameter() + " =", "new Out<>", List.of()));
      }
    }
    if (plan.world() != null) {
      plan.world()
          .settings()
          .forEach(s -> reads.add(read("double", s.local(), "doubleValue", s.name())));
    }
    for (StubMethod answer : plan.answers()) {
      JavaType type = java.util.Objects.requireNonNull(answer.returns());
      String name = java.util.Objects.requireNonNull(answer.answer());
      reads.add(read(type.name(), answer.field(), type.accessor(), name));
    }
    return reads;
  }

  private static String read(String type, String local, String accessor, String name) {
    return JavaText.call(
        4, type + " " + local + " =", "testCase." + accessor, List.of(JavaText.string(name)));
  }

  private static String output(Output output) {
    String name = JavaText.string(output.name());
    Tolerance tolerance = output.tolerance();
    if (tolerance == null) {
      return JavaText.call(4, "", "result.record", List.of(name, output.expression()));
    }
    String within =
        tolerance.equals(Tolerance.EXACT)
            ? "Tolerance.EXACT"
            : "new Tolerance("
                + tolerance.absolute()
                + ", "
                + tolerance.relative()
                + (tolerance.ulp() == 0 ? "" : ", " + tolerance.ulp())
                + ")";
    return JavaText.call(4, "", "result.compare", List.of(name, output.expression(), within));
  }
}
