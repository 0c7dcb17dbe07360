package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.python.PythonPlan.Argument;

/** The view of the concrete test driver. */
record ConcreteTestDriverView(
    String subject,
    String model,
    String imports,
    String component,
    List<String> setUp,
    boolean sequence,
    List<Call> calls) {
  /** A method that makes a call. */
  record Call(String declaration, String method, String statement) {}

  static ConcreteTestDriverView of(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    return new ConcreteTestDriverView(
        TestDriverView.subject(neutral),
        PythonText.plain(neutral.modelName()),
        imports(plan),
        plan.component(),
        setUp(neutral),
        plan.isSequence(),
        plan.calls().stream()
            .map(
                c ->
                    new Call(
                        TestDriverView.callDeclaration(c),
                        PythonText.plain(c.neutral().methodName()),
                        call(c)))
            .toList());
  }

  private static boolean hasOuts(PythonPlan plan) {
    return plan.arguments().stream().anyMatch(a -> a.direction() != Direction.IN);
  }

  private static String call(PythonPlan plan) {
    boolean returns = !plan.neutral().returnsNothing();
    String method =
        "method_of(component, " + PythonText.string(plan.neutral().method().name()) + ")";
    String open = returns ? "return " : "";
    Stream<String> arguments = plan.arguments().stream().map(Argument::local);
    if (hasOuts(plan)) {
      return PythonText.list(
          open + "call_with_outs(",
          Stream.of(
                  Stream.of(method),
                  arguments,
                  Stream.of("returns=" + (returns ? "True" : "False")))
              .flatMap(s -> s)
              .toList(),
          ")");
    }
    return PythonText.list(open + method + "(", arguments.toList(), ")");
  }

  private static List<String> setUp(HarnessPlan plan) {
    List<String> statements = new ArrayList<>();
    plan.component()
        .properties()
        .forEach(
            (name, value) ->
                statements.add(
                    PythonText.list(
                        "set_property(",
                        List.of("component", PythonText.string(name), PythonText.string(value)),
                        ")")));
    statements.add("self.begin(component)");
    for (HarnessPlan.Call call : plan.before()) {
      List<String> arguments = new ArrayList<>();
      for (int i = 0; i < call.arguments().size(); i++) {
        arguments.add(
            PythonType.expression(
                call.arguments().get(i), call.method().parameters().get(i).type()));
      }
      statements.add(
          PythonText.list(
              "method_of(component, " + PythonText.string(call.method().name()) + ")(",
              arguments,
              ")"));
    }
    return statements;
  }

  private static String imports(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    Imports imports =
        new Imports()
            .add(plan.packageName() + ".test_driver", "TestDriver")
            .add("sitaf_runtime.component", "method_of")
            .add("sitaf_runtime.run", "start")
            .add("sitaf_runtime.suite.test_case", "TestCase");
    plan.calls().forEach(c -> TestDriverView.importCall(c, imports));
    if (plan.calls().stream().anyMatch(ConcreteTestDriverView::hasOuts)) {
      imports.add("sitaf_runtime.component", "call_with_outs");
    }
    if (!neutral.component().properties().isEmpty()) {
      imports.add("sitaf_runtime.component", "set_property");
    }
    for (HarnessPlan.Call call : neutral.before()) {
      call.method().parameters().stream()
          .filter(p -> p.type() instanceof DataType.Enumeration)
          .forEach(p -> PythonType.importHint(p.type(), imports));
    }
    return imports.text();
  }
}
