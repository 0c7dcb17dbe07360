package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.JavaPlan.Argument;
import org.sitaf.core.harness.java.plan.JavaPlan.Call;
import org.sitaf.core.harness.java.plan.JavaPlan.Interface;
import org.sitaf.core.harness.java.plan.JavaPlan.Output;
import org.sitaf.core.harness.java.plan.JavaPlan.World;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.harness.plan.HarnessPlanner;
import org.sitaf.core.harness.plan.Hooks;
import org.sitaf.core.harness.plan.Words;
import org.sitaf.core.model.Value;

/** Plans a test application in Java, and reports everything that Java cannot express. */
public final class JavaPlanner {
  private final HarnessPlan plan;
  private final Diagnostics diagnostics;
  private final JavaNames names;
  private final String callName;

  private JavaPlanner(HarnessPlan plan, String callName, Diagnostics diagnostics) {
    this.plan = plan;
    this.callName = callName;
    this.diagnostics = diagnostics;
    // A local variable must not hide a type or the first part of a qualified name.
    this.names =
        new JavaNames(
            Stream.concat(
                    Stream.of(plan.component().className().split("\\.", 2)[0]),
                    plan.types().stream().map(HarnessPlan::simpleName))
                .toArray(String[]::new));
  }

  /**
   * Plans a test application.
   *
   * @param diagnostics receives everything that Java cannot express; after an error, the result
   *     must not be used
   */
  public static JavaPlan plan(HarnessPlan plan, Diagnostics diagnostics) {
    return new JavaPlanner(plan, "call", diagnostics).plan();
  }

  /** The package of a model's test application. */
  public static String packageName(String modelName) {
    return "sitaf.harness." + JavaNames.packagePart(modelName);
  }

  /** The name of a variable for a name in a document. */
  public static String local(String documentName) {
    return new JavaNames().local(documentName);
  }

  /** Plans the interfaces of an adapter, and reports everything that Java cannot express. */
  public static List<Interface> interfaces(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    className(plan.className(), diagnostics);
    JavaInterfaces planner = new JavaInterfaces(diagnostics);
    List<Interface> interfaces = new ArrayList<>();
    for (InterfaceDescription provided : plan.provided()) {
      planner
          .of(provided.name(), provided.source(), "provided", provided.methods())
          .ifPresent(interfaces::add);
    }
    return interfaces;
  }

  private JavaPlan plan() {
    String className = plan.component().className().replace('$', '.');
    String simpleName = className.substring(className.lastIndexOf('.') + 1);
    className(className, diagnostics);
    methodName(plan.interfaceName(), plan.method());
    List<Argument> arguments = arguments();
    World world = world();
    List<Interface> interfaces = interfaces();
    var stubs = new JavaStubPlanner(plan.stubs(), names).plan(interfaces);
    var types = JavaDeclaredType.of(plan.types(), diagnostics);
    errors();
    @Nullable JavaType returns =
        plan.returnsNothing() ? null : type(plan.method().returnType(), "its return type");
    List<Output> outputs = outputs(plan.outputs(), arguments);
    List<Output> watched = outputs(plan.watched(), List.of());
    List<Call> before = before();
    boolean clash = JavaNames.isUsedType(simpleName) || isDeclared(simpleName);
    return new JavaPlan(
        plan.modelName(),
        packageName(plan.modelName()),
        plan.interfaceName(),
        plan.method().name(),
        plan.description(),
        clash ? className : simpleName,
        clash ? null : className,
        plan.component().lifeCycle() == LifeCycle.SUITE,
        Hooks.among(plan.provided(), UnaryOperator.identity()),
        plan.component().period(),
        plan.method().callType() == CallType.NONBLOCKING,
        arguments,
        returns,
        world,
        interfaces,
        stubs,
        outputs,
        watched,
        plan.component().properties(),
        before,
        types,
        plan.errors(),
        callName,
        steps(),
        plan.sequence() == null
            ? List.of()
            : plan.sequence().properties().stream().map(HarnessPlan.Given::column).toList(),
        plan.sequence() == null ? List.of() : plan.sequence().overlapping(),
        plan.sequence() == null ? 1 : plan.sequence().threads());
  }

  private List<JavaPlan.Step> steps() {
    HarnessPlan.Sequence sequence = plan.sequence();
    List<JavaPlan.Step> steps = new ArrayList<>();
    if (sequence == null) {
      return steps;
    }
    JavaNames methods = new JavaNames();
    for (HarnessPlan.CallStep step : sequence.calls()) {
      String suffix = Words.raised(methods.local(step.name()));
      JavaPlan call = new JavaPlanner(step.call(), "call" + suffix, diagnostics).plan();
      steps.add(new JavaPlan.Step(step.name(), "step" + suffix, "prepare" + suffix, call, "", 0));
    }
    for (HarnessPlan.EventStep step : sequence.events()) {
      String suffix = Words.raised(methods.local(step.name()));
      steps.add(
          new JavaPlan.Step(
              step.name(), "event" + suffix, "", null, step.parameter(), step.value()));
    }
    return steps;
  }

  /** Whether a type of the interfaces has this name. */
  private boolean isDeclared(String name) {
    return plan.types().stream().anyMatch(t -> JavaNames.DECLARED.type(t).equals(name))
        || plan.stubs().stream().anyMatch(s -> s.name().equals(name))
        || plan.errors().contains(name);
  }

  private static void className(String className, Diagnostics diagnostics) {
    String[] parts = className.split("\\.", -1);
    for (String part : parts) {
      if (!JavaNames.isTypeName(part)) {
        diagnostics.error(
            HarnessPlanner.PROFILE,
            0,
            "component.class",
            "'" + className + "' is not the qualified name of a Java class");
        return;
      }
    }
    if (parts.length == 1) {
      diagnostics.error(
          HarnessPlanner.PROFILE,
          0,
          "component.class",
          className + " must be in a package, because the test must import it");
    }
  }

  private void methodName(String source, Method method) {
    if (!JavaNames.isName(method.name())) {
      diagnostics.error(
          source, method.line(), "method " + method.name(), "is not a valid Java method name");
    }
  }

  private List<Argument> arguments() {
    List<Argument> arguments = new ArrayList<>();
    for (HarnessPlan.Argument argument : plan.arguments()) {
      Parameter parameter = argument.parameter();
      JavaType type = type(parameter.type(), "parameter " + parameter.name());
      if (type != null) {
        arguments.add(JavaArguments.of(argument, type, names));
      }
    }
    return arguments;
  }

  /** The required interfaces, and the provided ones that an adapter implements. */
  private List<Interface> interfaces() {
    JavaInterfaces planner = new JavaInterfaces(diagnostics);
    List<Interface> interfaces = new ArrayList<>();
    for (HarnessPlan.Stub stub : plan.stubs()) {
      List<Method> methods = stub.methods().stream().map(HarnessPlan.StubMethod::method).toList();
      planner.of(stub.name(), stub.source(), "required", methods).ifPresent(interfaces::add);
    }
    if (plan.component().adapter() != null) {
      for (InterfaceDescription provided : plan.provided()) {
        if (plan.stubs().stream().noneMatch(s -> s.name().equals(provided.name()))) {
          planner
              .of(provided.name(), provided.source(), "provided", provided.methods())
              .ifPresent(interfaces::add);
        }
      }
    }
    return interfaces;
  }

  private void errors() {
    Set<String> taken = new HashSet<>();
    plan.types().forEach(t -> taken.add(JavaNames.DECLARED.type(t)));
    for (HarnessPlan.Stub stub : plan.stubs()) {
      if (!taken.add(stub.name())) {
        diagnostics.error(
            stub.source(), 0, "type_name " + stub.name(), "is also the name of a type");
      }
    }
    for (String error : plan.errors()) {
      if (!JavaNames.isTypeName(error) || JavaNames.isUsedType(error) || !taken.add(error)) {
        diagnostics.error(
            "interfaces",
            0,
            "exception " + error,
            "is not a valid exception name in a Java test, or another type has this name");
      }
    }
  }

  private @Nullable World world() {
    HarnessPlan.World world = plan.world();
    return world == null
        ? null
        : new World(
            world.path(),
            world.settings().stream()
                .map(
                    s ->
                        new World.Setting(
                            s.name(),
                            names.local(s.name()),
                            JavaText.comment(s.name())
                                + " in "
                                + JavaText.comment(s.unit())
                                + ", from "
                                + s.min()
                                + " to "
                                + s.max(),
                            s.isFault()))
                .toList(),
            world.settle(),
            world.runFor());
  }

  private static List<Output> outputs(List<HarnessPlan.Output> planned, List<Argument> arguments) {
    List<Output> outputs = new ArrayList<>();
    for (HarnessPlan.Output output : planned) {
      Source source = output.source();
      outputs.add(
          new Output(
              output.name(),
              output.type().isVoid() ? null : expression(source, arguments),
              !source.path().isEmpty(),
              source instanceof Source.Observation));
    }
    return outputs;
  }

  private static String expression(Source source, List<Argument> arguments) {
    if (source instanceof Source.OutParameter out) {
      return arguments.stream()
          .filter(a -> a.name().equals(out.parameter()))
          .map(a -> a.local() + ".get()")
          .findFirst()
          .orElse("null");
    }
    if (source instanceof Source.Observation observation) {
      return "simulationControl.observe(" + JavaText.string(observation.name()) + ")";
    }
    return source instanceof Source.DataPort port
        ? "dataPort(component, " + JavaText.string(port.port()) + ")"
        : "returned";
  }

  private List<Call> before() {
    List<Call> calls = new ArrayList<>();
    for (HarnessPlan.Call call : plan.before()) {
      methodName(HarnessPlanner.PROFILE, call.method());
      List<String> arguments = new ArrayList<>();
      Set<String> imports = new HashSet<>();
      for (int i = 0; i < call.arguments().size(); i++) {
        Parameter parameter = call.method().parameters().get(i);
        Optional<JavaType> type = JavaType.of(parameter.type());
        if (type.isEmpty()) {
          unknown(call.method(), "parameter " + parameter.name(), parameter.type());
        } else {
          Value value = call.arguments().get(i);
          arguments.add(type.get().expression(value));
          imports.addAll(type.get().imports());
        }
      }
      calls.add(new Call(call.method().name(), arguments, imports));
    }
    return calls;
  }

  private @Nullable JavaType type(DataType type, String what) {
    Optional<JavaType> known = JavaType.of(type);
    if (known.isEmpty()) {
      unknown(plan.method(), what, type);
    }
    return known.orElse(null);
  }

  private void unknown(Method method, String what, DataType type) {
    diagnostics.error(
        sourceOf(method),
        method.line(),
        "method " + method.name(),
        what + " is " + type.typeName() + "; " + JavaType.SUPPORTED);
  }

  private String sourceOf(Method method) {
    return plan.provided().stream()
        .filter(i -> i.methods().contains(method))
        .map(i -> i.source())
        .findFirst()
        .orElse(plan.interfaceName());
  }
}
