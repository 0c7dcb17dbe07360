package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.python.PythonPlan.Argument;
import org.sitaf.core.harness.python.PythonText.Group;

/** The view of the concrete test driver. */
record ConcreteTestDriverView(
    String documentation,
    String imports,
    String component,
    List<String> setUp,
    String beforeDeclaration,
    String afterDeclaration,
    List<Call> calls) {
  /** A method that makes a call. */
  record Call(String declaration, String documentation, String statement) {}

  static ConcreteTestDriverView of(PythonPlan plan) {
    HarnessPlan neutral = plan.neutral();
    return new ConcreteTestDriverView(
        PythonText.docstring(
            0,
            List.of(
                "Concrete test driver of "
                    + PythonText.plain(
                        plan.isSequence()
                            ? "sequences of " + neutral.interfaceName()
                            : neutral.methodName())
                    + ".",
                "You may edit this class. To keep your changes, save this file in the activity as"
                    + " harness/"
                    + PythonText.plain(neutral.modelName())
                    + "/concrete_test_driver.py. It then replaces the generated file.")),
        imports(plan),
        plan.component(),
        setUp(neutral),
        hook(plan, "before_case"),
        hook(plan, "after_case"),
        plan.calls().stream()
            .map(
                c ->
                    new Call(
                        TestDriverView.callDeclaration(c),
                        plan.isSequence()
                            ? TestDriverView.callDocumentation(c)
                            : "        \"\"\"Call the method under test. Only this call is timed.\"\"\"",
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
      return new Group(
              open + "call_with_outs(",
              Stream.of(
                      Stream.of(method),
                      arguments,
                      Stream.of("returns=" + (returns ? "True" : "False")))
                  .flatMap(s -> s)
                  .toList(),
              ")")
          .at(8);
    }
    return new Group(open + method + "(", arguments.toList(), ")").at(8);
  }

  private static List<String> setUp(HarnessPlan plan) {
    List<String> statements = new ArrayList<>();
    plan.component()
        .properties()
        .forEach(
            (name, value) ->
                statements.add(
                    new Group(
                            "set_property(",
                            ")",
                            "component",
                            PythonText.string(name),
                            PythonText.string(value))
                        .at(8)));
    statements.add("        self.begin(component)");
    for (HarnessPlan.Call call : plan.before()) {
      List<String> arguments = new ArrayList<>();
      for (int i = 0; i < call.arguments().size(); i++) {
        arguments.add(
            PythonType.expression(
                call.arguments().get(i), call.method().parameters().get(i).type()));
      }
      statements.add(
          new Group(
                  "method_of(component, " + PythonText.string(call.method().name()) + ")(",
                  arguments,
                  ")")
              .at(8));
    }
    return statements;
  }

  private static String hook(PythonPlan plan, String name) {
    return new Group(
            "def " + name + "(",
            ") -> None:",
            "self",
            "component: " + plan.component(),
            "test_case: TestCase")
        .at(4);
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
