package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.python.PythonPlan.StubMethod;

/** The view of an adapter skeleton. */
record AdapterView(
    String module,
    boolean answers,
    boolean hasImports,
    String imports,
    String name,
    String constructor,
    List<String> methods) {

  static AdapterView of(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    PythonPlanner.component(plan.className(), diagnostics);
    int dot = plan.className().lastIndexOf('.');
    Imports imports = new Imports();
    if (plan.hardware()) {
      imports.add("sitaf_runtime", "Hardware");
    }
    plan.required().forEach(r -> imports.add("sitaf_interfaces", r));
    Map<String, Method> written = new HashMap<>();
    List<String> methods = new ArrayList<>();
    for (InterfaceDescription provided : plan.provided()) {
      for (Method method : provided.methods()) {
        PythonPlanner.method(provided.source(), method, diagnostics);
        PythonType.importHint(method.returnType(), imports);
        method.parameters().forEach(p -> PythonType.importHint(p.type(), imports));
        Method other = written.putIfAbsent(method.name(), method);
        if (other == null) {
          methods.add(method(method, plan.answers()));
        } else if (!other.signature().equals(method.signature())) {
          diagnostics.error(
              provided.source(),
              method.line(),
              "method " + method.name(),
              "is overloaded, which Python does not support");
        }
      }
    }
    return new AdapterView(
        dot < 0 ? "" : plan.className().substring(0, dot),
        plan.answers(),
        !imports.isEmpty(),
        imports.text(),
        plan.className().substring(dot + 1),
        constructor(plan),
        methods);
  }

  private static String constructor(HarnessPlan.Adapter plan) {
    List<String> parameters = new ArrayList<>(List.of("self"));
    List<String> body = new ArrayList<>();
    if (!plan.answers()) {
      body.add("# Create the component here and store it in an attribute.");
    }
    if (plan.hardware()) {
      parameters.add("hardware: Hardware");
      body.add("# The hardware gives access to the simulated devices.");
      body.add("self._hardware = hardware");
    }
    if (!plan.required().isEmpty()) {
      body.add("# The required interfaces are implemented by the test stub.");
    }
    PythonNames scope = new PythonNames();
    for (String required : plan.required()) {
      String local = scope.local(required);
      parameters.add(local + ": " + required);
      body.add("self._" + local + " = " + local);
    }
    if (body.stream().allMatch(line -> line.startsWith("#"))) {
      body.add("pass");
    }
    String head = PythonText.list("    def __init__(", parameters, ") -> None:");
    return head + "\n        " + String.join("\n        ", body);
  }

  private static String method(Method method, boolean zeros) {
    PythonNames scope = new PythonNames();
    StubMethod planned =
        new StubMethod(
            new HarnessPlan.StubMethod(method, List.of()),
            "",
            null,
            method.parameters().stream()
                .filter(p -> p.direction() != Direction.OUT)
                .map(p -> scope.local(p.name()))
                .toList(),
            List.of());
    boolean answers = !method.returnType().isVoid() || !planned.parameters(true).isEmpty();
    String errors =
        method.raises().isEmpty()
            ? ""
            : "\n        # May raise exceptions of sitaf_interfaces: "
                + String.join(", ", method.raises())
                + ".";
    if (zeros) {
      return "    "
          + TestStubView.declaration(planned)
          + "\n        # Write the method here."
          + errors
          + "\n        "
          + zeros(method);
    }
    return "    "
        + TestStubView.declaration(planned)
        + "\n        # Delegate the call to the component"
        + (answers ? " and return its result." : ".")
        + errors
        + "\n        "
        + PythonText.list(
            "raise NotImplementedError(",
            List.of(PythonText.string(method.name() + " is not implemented yet")),
            ")");
  }

  private static String zeros(Method method) {
    List<String> parts = new ArrayList<>();
    if (!method.returnType().isVoid()) {
      parts.add(PythonType.zero(method.returnType()));
    }
    method.parameters().stream()
        .filter(p -> p.direction() != Direction.IN)
        .forEach(p -> parts.add(PythonType.zero(p.type())));
    return parts.isEmpty() ? "pass" : "return " + String.join(", ", parts);
  }
}
