package org.sitaf.core.harness.cpp;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.harness.plan.HarnessPlanner;

/** Reports everything in a plan that C++ cannot express. */
final class CppChecks {
  private final Diagnostics diagnostics;

  /** The kind of each name in {@code sitaf::interfaces}. */
  private final Map<String, String> shared = new HashMap<>();

  CppChecks(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  void check(HarnessPlan.Adapter plan) {
    className(plan.className());
    String simple = plan.className().substring(plan.className().lastIndexOf(':') + 1);
    for (InterfaceDescription provided : plan.provided()) {
      if (plan.answers()) {
        // The skeleton of a component does not include the interface's class.
        methods(provided.source(), simple, provided.methods());
      } else {
        type(provided.source(), provided.name(), "interface");
        methods(provided.source(), provided.name(), provided.methods());
      }
    }
  }

  private void className(String className) {
    if (!CppNames.isQualifiedName(className)) {
      diagnostics.error(
          HarnessPlanner.PROFILE,
          0,
          "component.class",
          "'" + className + "' is not a valid C++ class name, such as robot::InfraredSensor");
    }
  }

  void check(HarnessPlan plan) {
    className(plan.component().className());
    method(plan.interfaceName(), plan.method());
    HarnessPlan.Sequence sequence = plan.sequence();
    if (sequence != null) {
      sequence.calls().forEach(c -> method(c.call().interfaceName(), c.call().method()));
      sequence.calls().forEach(c -> ports(c.call()));
    }
    plan.before().forEach(call -> method(HarnessPlanner.PROFILE, call.method()));
    if (plan.component().adapter() != null) {
      for (InterfaceDescription provided : plan.provided()) {
        type(provided.source(), provided.name(), "interface");
        methods(provided.source(), provided.name(), provided.methods());
      }
    }
    for (HarnessPlan.Stub stub : plan.stubs()) {
      type(stub.source(), stub.name(), "interface");
      methods(
          stub.source(),
          stub.name(),
          stub.methods().stream().map(HarnessPlan.StubMethod::method).toList());
    }
    ports(plan);
    CppNames.DECLARED.check(plan.types(), plan.interfaceName(), diagnostics);
    plan.types().forEach(type -> declared(plan, type));
    plan.errors().forEach(error -> type(plan.interfaceName(), error, "error"));
  }

  private void ports(HarnessPlan plan) {
    for (HarnessPlan.Output output :
        Stream.concat(plan.outputs().stream(), plan.watched().stream()).toList()) {
      if (output.source() instanceof Source.DataPort port && !CppNames.isName(port.port())) {
        diagnostics.error(
            HarnessPlanner.PROFILE,
            0,
            "data_port " + port.port(),
            "is not a valid C++ method name");
      }
    }
  }

  private void methods(String source, String interfaceName, List<Method> methods) {
    Set<String> signatures = new HashSet<>();
    for (Method method : methods) {
      method(source, method);
      if (method.name().equals(interfaceName) || method.name().equals(interfaceName + "Stub")) {
        problem(
            source, method, "has the name of its class, which is reserved for constructors in C++");
      }
      String signature =
          method.parameters().stream()
              .map(p -> CppType.parameter(p, "", true))
              .collect(Collectors.joining(",", method.name() + "(", ")"));
      if (!signatures.add(signature)) {
        problem(source, method, "has the same parameters in C++ as another overload");
      }
    }
  }

  private void method(String source, Method method) {
    if (!CppNames.isName(method.name())) {
      problem(source, method, "is not a valid C++ method name");
    }
  }

  private void declared(HarnessPlan plan, DataType type) {
    unique(plan.interfaceName(), CppNames.DECLARED.type(type), "type");
    if (type instanceof DataType.Struct struct
        ? struct.members().isEmpty()
        : ((DataType.Enumeration) type).literals().isEmpty()) {
      diagnostics.error(
          plan.interfaceName(), 0, "type " + type.typeName(), "has neither members nor literals");
    }
  }

  private void type(String source, String name, String kind) {
    if (!CppNames.isTypeName(name)) {
      diagnostics.error(
          source,
          0,
          kind + " " + name,
          "is not a valid C++ class name or is reserved for test applications");
    }
    unique(source, name, kind);
  }

  private void unique(String source, String name, String kind) {
    String other = shared.put(name, kind);
    if (other != null && !(other.equals(kind) && kind.equals("interface"))) {
      diagnostics.error(source, 0, kind + " " + name, "is also the name of an " + other);
    }
  }

  private void problem(String source, Method method, String problem) {
    diagnostics.error(source, method.line(), "method " + method.name(), problem);
  }
}
