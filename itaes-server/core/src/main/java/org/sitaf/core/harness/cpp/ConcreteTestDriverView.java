package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.Words;

/** The view of the concrete test driver. */
record ConcreteTestDriverView(
    String namespace,
    List<String> includes,
    String subject,
    String model,
    List<String> properties,
    List<String> before,
    boolean sequence,
    List<Call> calls) {
  /** A method that makes a call. */
  record Call(String method, String head, String statement) {}

  static ConcreteTestDriverView of(CppPlan plan) {
    List<DataType> types = new ArrayList<>();
    plan.plan().before().forEach(c -> c.method().parameters().forEach(p -> types.add(p.type())));
    return new ConcreteTestDriverView(
        plan.namespace(),
        new Includes().own("TestDriver.hpp").types(types).lines(),
        plan.called(),
        CppText.comment(plan.plan().modelName()),
        properties(plan),
        before(plan),
        plan.isSequence(),
        plan.calls().stream().map(ConcreteTestDriverView::call).toList());
  }

  private static Call call(CppPlan plan) {
    boolean returns = !plan.plan().returnsNothing();
    return new Call(
        plan.called(),
        plan.callHead(),
        CppText.list(
            (returns ? "return " : "") + "component." + plan.plan().method().name() + "(",
            plan.arguments().stream().map(CppPlan.Argument::local).toList(),
            ");"));
  }

  private static List<String> properties(CppPlan plan) {
    List<String> statements = new ArrayList<>();
    plan.plan()
        .component()
        .properties()
        .forEach((name, value) -> statements.add(property(name, CppText.string(value))));
    for (String name : plan.properties()) {
      statements.add(property(name, "currentCase().literal(" + CppText.string(name) + ").c_str()"));
    }
    return statements;
  }

  private static String property(String name, String value) {
    String setter = "set" + Words.raised(name);
    return CppText.list(
        "runtime::setProperty(",
        List.of(
            "*component",
            CppText.string(name),
            value,
            CppNames.isName(setter) ? "SITAF_SETTER(" + setter + ")" : "runtime::NoSetter{}"),
        ");");
  }

  private static List<String> before(CppPlan plan) {
    List<String> statements = new ArrayList<>();
    for (var call : plan.plan().before()) {
      List<String> arguments = new ArrayList<>();
      for (int i = 0; i < call.arguments().size(); i++) {
        arguments.add(
            CppType.expression(call.arguments().get(i), call.method().parameters().get(i).type()));
      }
      statements.add(CppText.list("component->" + call.method().name() + "(", arguments, ");"));
    }
    return statements;
  }
}
