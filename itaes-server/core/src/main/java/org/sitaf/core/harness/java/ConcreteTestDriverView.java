package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Argument;
import org.sitaf.core.harness.java.plan.JavaText;

/** The view of the concrete test driver. */
record ConcreteTestDriverView(
    String packageName,
    SortedSet<String> imports,
    String subject,
    String model,
    String component,
    List<String> setUp,
    boolean sequence,
    List<Call> calls) {
  /** A method that makes a call. */
  record Call(String method, String declaration, String statement) {}

  static ConcreteTestDriverView of(JavaPlan plan) {
    SortedSet<String> imports = new TreeSet<>();
    imports.add("org.sitaf.runtime.TestRun");
    imports.add("org.sitaf.runtime.suite.TestCase");
    plan.calls().forEach(c -> TestDriverView.addTypesOfCall(c, imports));
    plan.before().forEach(c -> imports.addAll(c.imports()));
    return new ConcreteTestDriverView(
        plan.packageName(),
        imports,
        JavaText.comment(TestDriverView.subject(plan)),
        JavaText.comment(plan.modelName()),
        plan.component(),
        setUp(plan),
        plan.isSequence(),
        plan.calls().stream().map(ConcreteTestDriverView::call).toList());
  }

  private static Call call(JavaPlan plan) {
    return new Call(
        TestDriverView.methodUnderTest(plan),
        TestDriverView.callDeclaration(plan),
        JavaText.call(
            plan.returns() == null ? "" : "return",
            "component." + plan.method(),
            plan.arguments().stream().map(Argument::local).toList()));
  }

  private static List<String> setUp(JavaPlan plan) {
    List<String> statements = new ArrayList<>();
    plan.properties()
        .forEach(
            (name, value) ->
                statements.add(
                    JavaText.call(
                        "",
                        "setProperty",
                        List.of("component", JavaText.string(name), JavaText.string(value)))));
    plan.caseProperties()
        .forEach(
            name ->
                statements.add(
                    JavaText.call(
                        "",
                        "setProperty",
                        List.of(
                            "component",
                            JavaText.string(name),
                            "currentCase().stringValue(" + JavaText.string(name) + ")"))));
    statements.add("begin(component);");
    plan.before()
        .forEach(c -> statements.add(JavaText.call("", "component." + c.method(), c.arguments())));
    return statements;
  }
}
