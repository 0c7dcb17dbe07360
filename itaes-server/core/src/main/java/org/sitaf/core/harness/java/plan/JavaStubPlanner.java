package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.JavaPlan.Stub;
import org.sitaf.core.harness.java.plan.JavaPlan.StubMethod;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Answer;

/**
 * Spells the test stub: one Java interface for each required interface, one answer a case for each
 * of its methods.
 */
final class JavaStubPlanner {
  private final List<HarnessPlan.Stub> stubs;
  private final JavaNames names;
  private final Diagnostics diagnostics;

  JavaStubPlanner(List<HarnessPlan.Stub> stubs, JavaNames names, Diagnostics diagnostics) {
    this.stubs = stubs;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  List<Stub> plan() {
    List<Stub> planned = new ArrayList<>();
    for (HarnessPlan.Stub stub : stubs) {
      if (!JavaNames.isTypeName(stub.name()) || JavaNames.isUsedType(stub.name())) {
        diagnostics.error(
            stub.source(),
            0,
            "type_name " + stub.name(),
            JavaNames.isUsedType(stub.name())
                ? "is a name that test applications use themselves; rename the interface"
                : "is not a name that a Java interface can have");
        continue;
      }
      planned.add(stub(stub));
    }
    return planned;
  }

  private Stub stub(HarnessPlan.Stub stub) {
    List<StubMethod> methods = new ArrayList<>();
    Set<String> signatures = new HashSet<>();
    for (HarnessPlan.StubMethod stubMethod : stub.methods()) {
      Method method = stubMethod.method();
      if (!JavaNames.isName(method.name()) || JavaNames.isObjectMethod(method.name())) {
        inMethod(stub, method, "is not a name that a method of a Java interface can have");
        continue;
      }
      List<String> parameters = parameters(stub, method);
      boolean isVoid = HarnessPlan.isVoid(method.returnType());
      Optional<JavaType> returns = JavaType.of(method.returnType());
      if (!isVoid && returns.isEmpty()) {
        unknown(stub, method, "its return type", method.returnType());
        continue;
      }
      if (!signatures.add(method.name() + typesOf(parameters))) {
        inMethod(stub, method, "has the same parameters in Java as another overload");
        continue;
      }
      methods.add(planned(stub, stubMethod, returns.orElse(null), parameters));
    }
    return new Stub(stub.name(), stub.source(), names.local(stub.name()), methods);
  }

  private StubMethod planned(
      HarnessPlan.Stub stub,
      HarnessPlan.StubMethod stubMethod,
      @Nullable JavaType returns,
      List<String> parameters) {
    Method method = stubMethod.method();
    if (stubMethod.answers().stream().anyMatch(a -> !isSimple(a))) {
      inMethod(
          stub,
          method,
          "errors, delays, out-parameters and answers of later calls are not supported in Java"
              + " tests yet");
    }
    if (returns == null) {
      return new StubMethod(method.name(), null, parameters, "", null);
    }
    return new StubMethod(
        method.name(),
        returns,
        parameters,
        names.local(stub.name() + "." + method.name()),
        stubMethod.answers().isEmpty() ? null : stubMethod.answers().get(0).column());
  }

  private static boolean isSimple(Answer answer) {
    return answer.plain() && answer.parameter() == null && answer.fromCall() == 1;
  }

  private List<String> parameters(HarnessPlan.Stub stub, Method method) {
    JavaNames scope = new JavaNames();
    List<String> parameters = new ArrayList<>();
    for (Parameter parameter : method.parameters()) {
      Optional<JavaType> type = JavaType.of(parameter.type());
      if (type.isEmpty()) {
        unknown(stub, method, "parameter " + parameter.name(), parameter.type());
      } else {
        String spelled =
            parameter.direction() == Direction.IN
                ? type.get().name()
                : "Out<" + type.get().boxed() + ">";
        parameters.add(spelled + " " + scope.local(parameter.name()));
      }
    }
    return parameters;
  }

  private static List<String> typesOf(List<String> parameters) {
    // Java tells overloads apart by erased types: what Out holds does not count.
    return parameters.stream().map(p -> p.split("[ <]", 2)[0]).toList();
  }

  private void unknown(HarnessPlan.Stub stub, Method method, String what, DataType type) {
    inMethod(stub, method, what + " is " + type.spelling() + "; " + JavaType.SUPPORTED);
  }

  private void inMethod(HarnessPlan.Stub stub, Method method, String problem) {
    diagnostics.error(stub.source(), method.line(), "method " + method.name(), problem);
  }
}
