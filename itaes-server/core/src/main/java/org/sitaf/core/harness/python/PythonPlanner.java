package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlanner;

/** Plans a test application in Python, and reports everything that Python cannot express. */
final class PythonPlanner {
  private final HarnessPlan neutral;
  private final Diagnostics diagnostics;
  private final PythonNames locals = new PythonNames();

  private PythonPlanner(HarnessPlan neutral, Diagnostics diagnostics) {
    this.neutral = neutral;
    this.diagnostics = diagnostics;
  }

  static PythonPlan plan(HarnessPlan neutral, Diagnostics diagnostics) {
    return new PythonPlanner(neutral, diagnostics).plan("call");
  }

  /** The package of a model's test application. */
  static String packageName(String modelName) {
    return "sitaf_harness." + PythonNames.packagePart(modelName);
  }

  private PythonPlan plan(String callName) {
    String qualified = neutral.component().className();
    int dot = qualified.lastIndexOf('.');
    component(qualified, diagnostics);
    String simple = qualified.substring(dot + 1);
    names();
    if (neutral.component().period() != null && neutral.world() == null) {
      inProfile(
          diagnostics,
          "component.execution",
          "a periodic component needs simulation time, but activity.yaml has no world");
    }
    List<PythonPlan.Argument> arguments =
        neutral.arguments().stream()
            .map(a -> new PythonPlan.Argument(a, locals.local(a.name())))
            .toList();
    List<PythonPlan.Setting> settings =
        neutral.world() == null
            ? List.of()
            : neutral.world().settings().stream()
                .map(s -> new PythonPlan.Setting(s, locals.local(s.name())))
                .toList();
    return new PythonPlan(
        neutral,
        packageName(neutral.modelName()),
        PythonNames.isTypeName(simple) && !isDeclared(simple) ? simple : "ComponentUnderTest",
        dot < 0 ? "" : qualified.substring(0, dot),
        simple,
        arguments,
        settings,
        neutral.stubs().stream().map(this::stub).toList(),
        callName,
        steps());
  }

  private List<PythonPlan.Step> steps() {
    HarnessPlan.Sequence sequence = neutral.sequence();
    List<PythonPlan.Step> steps = new ArrayList<>();
    if (sequence == null) {
      return steps;
    }
    PythonNames methods = new PythonNames();
    for (HarnessPlan.CallStep step : sequence.calls()) {
      String suffix = methods.local(step.name());
      PythonPlan call = new PythonPlanner(step.call(), diagnostics).plan("call_" + suffix);
      steps.add(
          new PythonPlan.Step(step.name(), "step_" + suffix, "prepare_" + suffix, call, null));
    }
    for (HarnessPlan.EventStep step : sequence.events()) {
      String suffix = methods.local(step.name());
      steps.add(new PythonPlan.Step(step.name(), "event_" + suffix, "", null, step));
    }
    return steps;
  }

  /** Checks the name of the component's class. */
  static void component(String qualified, Diagnostics diagnostics) {
    String[] parts = qualified.split("\\.", -1);
    for (String part : parts) {
      if (!PythonNames.isName(part)) {
        inProfile(
            diagnostics,
            "component.class",
            "'" + qualified + "' is not the qualified name of a Python class");
        return;
      }
    }
    if (parts.length == 1) {
      inProfile(
          diagnostics,
          "component.class",
          qualified + " must include its module, such as sensors." + qualified);
    } else if (parts[0].equals("sitaf_harness")
        || parts[0].equals("sitaf_interfaces")
        || parts[0].equals("sitaf_runtime")) {
      inProfile(
          diagnostics,
          "component.class",
          "the module " + parts[0] + " is reserved for SITAF; rename the module");
    }
  }

  private boolean isDeclared(String name) {
    return neutral.types().stream().anyMatch(t -> PythonNames.DECLARED.type(t).equals(name))
        || neutral.stubs().stream().anyMatch(s -> s.name().equals(name));
  }

  /** Checks the names of methods and types. */
  private void names() {
    method(neutral.interfaceName(), neutral.method());
    neutral.before().forEach(call -> method(HarnessPlanner.PROFILE, call.method()));
    PythonNames.DECLARED.check(neutral.types(), neutral.interfaceName(), diagnostics);
    Set<String> types = new HashSet<>();
    for (DataType type : neutral.types()) {
      types.add(PythonNames.DECLARED.type(type));
      if (type instanceof DataType.Enumeration enumeration
          && enumeration.literals().contains("mro")) {
        diagnostics.error(
            neutral.interfaceName(),
            0,
            "type " + type.typeName(),
            "'mro' is not a valid name of a literal in Python");
      }
    }
    for (HarnessPlan.Stub stub : neutral.stubs()) {
      typeName(stub.source(), stub.name());
      if (!types.add(stub.name())) {
        diagnostics.error(
            stub.source(), 0, "type_name " + stub.name(), "is also the name of a type");
      }
    }
    for (HarnessPlan.Stub stub : neutral.stubs()) {
      if (types.contains(stub.name() + "Stub")) {
        diagnostics.error(
            stub.source(),
            0,
            "type_name " + stub.name(),
            "the name of its stub, " + stub.name() + "Stub, is also the name of a type");
      }
    }
    for (String error : neutral.errors()) {
      typeName(neutral.interfaceName(), error);
      if (!types.add(error)) {
        diagnostics.error(
            neutral.interfaceName(), 0, "exception " + error, "is also the name of another type");
      }
    }
  }

  private void method(String source, Method method) {
    method(source, method, diagnostics);
  }

  /** Checks the name of a method. */
  static void method(String source, Method method, Diagnostics diagnostics) {
    if (!PythonNames.isName(method.name())) {
      diagnostics.error(
          source, method.line(), "method " + method.name(), "is not a valid Python method name");
    }
  }

  private void typeName(String source, String name) {
    if (!PythonNames.isTypeName(name)) {
      diagnostics.error(
          source,
          0,
          "type_name " + name,
          PythonNames.isUsedType(name)
              ? "is reserved for test applications; rename it"
              : "is not a valid Python class name");
    }
  }

  private PythonPlan.Stub stub(HarnessPlan.Stub stub) {
    Set<String> taken = new HashSet<>();
    stub.methods().forEach(m -> taken.add(m.method().name()));
    List<PythonPlan.StubMethod> methods = new ArrayList<>();
    Set<String> seen = new HashSet<>();
    for (HarnessPlan.StubMethod method : stub.methods()) {
      method(stub.source(), method.method());
      String name = method.method().name();
      if (!seen.add(name)) {
        diagnostics.error(
            stub.source(),
            method.method().line(),
            "method " + name,
            "is overloaded, and Python has one method of a name only");
      }
      String snake = PythonNames.snakeCase(name);
      @Nullable String alias = PythonNames.isName(snake) && taken.add(snake) ? snake : null;
      String field = "on_" + snake;
      while (!taken.add(field)) {
        field += "_";
      }
      PythonNames scope = new PythonNames();
      methods.add(
          new PythonPlan.StubMethod(
              method,
              field,
              alias,
              method.method().parameters().stream()
                  .filter(p -> p.direction() != Direction.OUT)
                  .map(p -> scope.local(p.name()))
                  .toList(),
              method.answers().stream()
                  .map(a -> new PythonPlan.Answer(a, locals.local(a.column())))
                  .toList()));
    }
    return new PythonPlan.Stub(stub, locals.local(stub.name()), methods);
  }

  private static void inProfile(Diagnostics diagnostics, String element, String problem) {
    diagnostics.error(HarnessPlanner.PROFILE, 0, element, problem);
  }
}
