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
    String documentation,
    String component,
    List<String> setUp,
    String beforeDeclaration,
    String afterDeclaration,
    List<Call> calls) {
  /** A method that makes a call. */
  record Call(String documentation, String declaration, String statement) {}

  static ConcreteTestDriverView of(JavaPlan plan) {
    SortedSet<String> imports = new TreeSet<>();
    imports.add("org.sitaf.runtime.TestRun");
    imports.add("org.sitaf.runtime.suite.TestCase");
    plan.calls().forEach(c -> TestDriverView.addTypesOfCall(c, imports));
    plan.before().forEach(c -> imports.addAll(c.imports()));
    return new ConcreteTestDriverView(
        plan.packageName(),
        imports,
        documentation(plan),
        plan.component(),
        setUp(plan),
        hook(plan, "beforeCase"),
        hook(plan, "afterCase"),
        plan.calls().stream().map(c -> call(c, plan.isSequence())).toList());
  }

  private static Call call(JavaPlan plan, boolean inSequence) {
    return new Call(
        inSequence
            ? TestDriverView.callDocumentation(plan)
            : "  /** Calls the method under test. Only this call is timed. */",
        TestDriverView.callDeclaration(plan, "", " {"),
        JavaText.call(
            4,
            plan.returns() == null ? "" : "return",
            "component." + plan.method(),
            plan.arguments().stream().map(Argument::local).toList()));
  }

  private static String documentation(JavaPlan plan) {
    return JavaText.javadoc(
        0,
        List.of(
            "Concrete test driver of "
                + JavaText.comment(
                    plan.isSequence()
                        ? "sequences of " + plan.interfaceName()
                        : plan.interfaceName() + "." + plan.method())
                + ". You may edit this class.",
            "To keep your changes, save this file in the activity as harness/"
                + JavaText.comment(plan.modelName())
                + "/ConcreteTestDriver.java. It then replaces the generated file."),
        List.of());
  }

  private static List<String> setUp(JavaPlan plan) {
    List<String> statements = new ArrayList<>();
    plan.properties()
        .forEach(
            (name, value) ->
                statements.add(
                    JavaText.call(
                        4,
                        "",
                        "setProperty",
                        List.of("component", JavaText.string(name), JavaText.string(value)))));
    plan.caseProperties()
        .forEach(
            name ->
                statements.add(
                    JavaText.call(
                        4,
                        "",
                        "setProperty",
                        List.of(
                            "component",
                            JavaText.string(name),
                            "currentCase().stringValue(" + JavaText.string(name) + ")"))));
    statements.add("    begin(component);");
    plan.before()
        .forEach(
            c -> statements.add(JavaText.call(4, "", "component." + c.method(), c.arguments())));
    return statements;
  }

  private static String hook(JavaPlan plan, String name) {
    return JavaText.declaration(
        2,
        "protected void " + name,
        List.of(plan.component() + " component", "TestCase testCase"),
        true,
        " {}");
  }
}
