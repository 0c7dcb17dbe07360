package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Given;
import org.sitaf.core.harness.plan.HarnessPlan.Output;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.harness.plan.Hooks;
import org.sitaf.core.harness.python.PythonPlan.Answer;
import org.sitaf.core.harness.python.PythonPlan.Argument;

/** The view of the test driver: the five steps of Fig. 10. */
record TestDriverView(
    String subject,
    String model,
    String description,
    String imports,
    String component,
    String suiteLife,
    boolean hasNotHooks,
    String notHooks,
    String newSimulationControl,
    String callDeclaration,
    String methodUnderTest,
    String make,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    boolean periodic,
    String period,
    boolean nonblocking,
    String call,
    boolean runOn,
    String outcome,
    List<String> outputs) {

  private static final String RUNTIME = "sitaf_runtime.";

  static TestDriverView of(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    boolean nonblocking = neutral.method().callType() == CallType.NONBLOCKING;
    List<String> notHooks = Hooks.among(neutral.provided(), PythonNames::snakeCase);
    return new TestDriverView(
        subject(neutral),
        PythonText.plain(neutral.modelName()),
        PythonText.plain(neutral.description()),
        imports(plan),
        plan.component(),
        neutral.component().lifeCycle() == LifeCycle.SUITE ? "True" : "False",
        !notHooks.isEmpty(),
        PythonText.list(
            "NOT_HOOKS = (",
            notHooks.stream().map(PythonText::string).toList(),
            notHooks.size() == 1 ? ",)" : ")"),
        PythonText.list(
            "self.simulation_control = SimulationControl(",
            neutral.world() == null ? List.of() : List.of("run.simulation"),
            ")"),
        callDeclaration(plan),
        PythonText.plain(neutral.methodName()),
        make(plan),
        reads(plan),
        PythonText.list(
            "self.simulation_control.prepare(",
            plan.settings().stream().map(PythonPlan.Setting::local).toList(),
            ")"),
        PythonText.list(
            "self.test_stub.prepare(", plan.answers().stream().map(Answer::local).toList(), ")"),
        watches(plan),
        plan.isPeriodic(),
        plan.isPeriodic() ? PythonText.real(neutral.component().period().toNanos() / 1e9) : "",
        nonblocking,
        call(plan),
        plan.runsOn(),
        outcome(plan),
        neutral.outputs().stream().map(o -> output(plan, o)).toList());
  }

  static String make(PythonPlan plan) {
    List<String> arguments = new ArrayList<>();
    arguments.add(plan.component());
    plan.stubs().forEach(s -> arguments.add("self.test_stub." + s.field()));
    if (!plan.properties().isEmpty()) {
      arguments.add("inputs=self.inputs()");
    }
    return PythonText.list("return self.make(", arguments, ")");
  }

  private static String returned(PythonPlan plan) {
    return plan.neutral().returnsNothing() ? "" : "returned = ";
  }

  static String call(PythonPlan plan) {
    return plan.neutral().method().callType() == CallType.NONBLOCKING
        ? PythonText.list(
            "pending = self.call_nonblocking(",
            Stream.concat(Stream.of("self." + plan.callName()), callArguments(plan).stream())
                .toList(),
            ")")
        : PythonText.list(
            returned(plan) + "self." + plan.callName() + "(", callArguments(plan), ")");
  }

  static String outcome(PythonPlan plan) {
    return returned(plan) + "pending.outcome()";
  }

  private static List<String> callArguments(PythonPlan plan) {
    return Stream.concat(Stream.of("component"), plan.arguments().stream().map(Argument::local))
        .toList();
  }

  /** The declaration of the method that makes the call. */
  static String callDeclaration(PythonPlan plan) {
    return PythonText.list(
        "def " + plan.callName() + "(",
        Stream.concat(
                Stream.of("self", "component: " + plan.component()),
                plan.arguments().stream().map(a -> a.local() + ": " + a.hint()))
            .toList(),
        ") -> " + PythonType.hint(plan.neutral().method().returnType()) + ":");
  }

  /** What the driver tests, escaped for a docstring. */
  static String subject(HarnessPlan plan) {
    return PythonText.plain(
        plan.sequence() == null ? plan.methodName() : "sequences of " + plan.interfaceName());
  }

  /** Adds the imports of the call's declaration. */
  static void importCall(PythonPlan plan, Imports imports) {
    imports.add(
        plan.componentModule(),
        plan.component().equals(plan.componentClass())
            ? plan.component()
            : plan.componentClass() + " as " + plan.component());
    for (Argument argument : plan.arguments()) {
      PythonType.importHint(argument.type(), imports);
      if (argument.direction() != Direction.IN) {
        imports.add(RUNTIME + "out", argument.direction() == Direction.OUT ? "Out" : "InOut");
      }
    }
    PythonType.importHint(plan.neutral().method().returnType(), imports);
  }

  private static String imports(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    Imports imports =
        new Imports()
            .add("abc", "abstractmethod")
            .add(plan.packageName() + ".simulation_control", "SimulationControl")
            .add(plan.packageName() + ".test_stub", "TestStub")
            .add(RUNTIME + "driver", "SuiteDriver")
            .add(RUNTIME + "run", "TestRun")
            .add(RUNTIME + "suite.result", "CaseResult")
            .add(RUNTIME + "suite.test_case", "TestCase");
    importCall(plan, imports);
    importValues(plan, imports);
    return imports.text();
  }

  /** Adds the imports of the values that are read and recorded. */
  static void importValues(PythonPlan plan, Imports imports) {
    HarnessPlan neutral = plan.neutral();
    for (Argument argument : plan.arguments()) {
      if (!argument.neutral().given().isEmpty() || argument.direction() == Direction.INOUT) {
        PythonType.importKind(argument.type(), imports);
      }
    }
    if (!plan.settings().isEmpty()) {
      imports.add(RUNTIME + "suite.kinds", "FLOAT64");
    }
    for (Answer answer : plan.answers()) {
      if (!answer.neutral().plain()) {
        imports.add(RUNTIME + "stub", "answer");
        imports.add(plan.packageName() + ".test_stub", "ERRORS");
      }
      PythonType.importKind(answer.neutral().type(), imports);
    }
    for (Output output :
        Stream.concat(neutral.outputs().stream(), neutral.watched().stream()).toList()) {
      if (output.type().isVoid()) {
        continue;
      }
      PythonType.importKind(output.type(), imports);
      if (!output.source().path().isEmpty()) {
        imports.add(RUNTIME + "component", "part_of");
      }
      if (output.source() instanceof Source.DataPort) {
        imports.add(RUNTIME + "component", "port_of");
      }
    }
  }

  static List<String> reads(PythonPlan plan) {
    List<String> reads = new ArrayList<>();
    for (Argument argument : plan.arguments()) {
      String value = value(argument);
      switch (argument.direction()) {
        case IN -> reads.add(read(argument.local(), argument));
        case OUT -> reads.add(argument.local() + ": " + argument.hint() + " = Out()");
        case INOUT -> reads.add(argument.local() + " = InOut(" + value + ")");
      }
    }
    plan.settings().forEach(s -> reads.add(read(s.local(), s.neutral().name(), "FLOAT64")));
    for (Answer answer : plan.answers()) {
      String kind = PythonType.kind(answer.neutral().type());
      reads.add(
          read(
              answer.local(),
              answer.neutral().column(),
              answer.neutral().plain() ? kind : "answer(" + kind + ", ERRORS)"));
    }
    return reads;
  }

  private static String read(String local, String column, String kind) {
    return PythonText.list(
        local + " = test_case.read(", List.of(PythonText.string(column), kind), ")");
  }

  private static String read(String local, Argument argument) {
    List<Given> given = argument.neutral().given();
    if (given.size() == 1 && given.get(0).path().isEmpty()) {
      return read(local, given.get(0).column(), PythonType.kind(argument.type()));
    }
    return PythonText.list(
        local + " = test_case.assemble(",
        List.of(PythonType.kind(argument.type()), parts(given)),
        ")");
  }

  private static String value(Argument argument) {
    List<Given> given = argument.neutral().given();
    String kind = PythonType.kind(argument.type());
    if (given.size() == 1 && given.get(0).path().isEmpty()) {
      return "test_case.read(" + PythonText.string(given.get(0).column()) + ", " + kind + ")";
    }
    return "test_case.assemble(" + kind + ", " + parts(given) + ")";
  }

  private static String parts(List<Given> given) {
    List<String> parts = new ArrayList<>();
    for (Given part : given) {
      List<String> steps = part.path().stream().map(TestDriverView::step).toList();
      parts.add(
          PythonText.string(part.column())
              + ": ("
              + String.join(", ", steps)
              + (steps.size() == 1 ? ",)" : ")"));
    }
    return "{" + String.join(", ", parts) + "}";
  }

  private static String step(Step step) {
    return step instanceof Step.Member member
        ? PythonText.string(PythonNames.DECLARED.member(member.name()))
        : String.valueOf(((Step.Element) step).index());
  }

  /** Records the output data ports that trajectory conditions use. */
  static List<String> watches(PythonPlan plan) {
    return plan.neutral().watched().stream()
        .map(
            port ->
                PythonText.list(
                    "self.watch(",
                    List.of(
                        PythonText.string(port.name()),
                        "lambda: " + expression(plan, port.source()),
                        PythonType.kind(port.type())),
                    ")"))
        .toList();
  }

  static String output(PythonPlan plan, Output output) {
    List<String> arguments = new ArrayList<>();
    arguments.add(PythonText.string(output.name()));
    if (output.type().isVoid()) {
      return PythonText.list("result.record_return(", arguments, ")");
    }
    arguments.add(expression(plan, output.source()));
    arguments.add(PythonType.kind(output.type()));
    return PythonText.list("result.record(", arguments, ")");
  }

  private static String expression(PythonPlan plan, Source source) {
    if (source instanceof Source.Observation observation) {
      return "self.simulation_control.observe(" + PythonText.string(observation.name()) + ")";
    }
    String whole = "returned";
    if (source instanceof Source.DataPort port) {
      whole = "port_of(component, " + PythonText.string(port.port()) + ")";
    }
    if (source instanceof Source.OutParameter out) {
      whole =
          plan.arguments().stream()
              .filter(a -> a.neutral().name().equals(out.parameter()))
              .map(a -> a.local() + ".value")
              .findFirst()
              .orElse("None");
    }
    List<String> steps = source.path().stream().map(TestDriverView::step).toList();
    return steps.isEmpty() ? whole : "part_of(" + whole + ", " + String.join(", ", steps) + ")";
  }
}
