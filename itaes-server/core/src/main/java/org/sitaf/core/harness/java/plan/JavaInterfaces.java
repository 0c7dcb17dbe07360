package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.JavaPlan.Interface;
import org.sitaf.core.harness.java.plan.JavaPlan.JavaParameter;
import org.sitaf.core.harness.java.plan.JavaPlan.Signature;

/** Plans interfaces in Java. */
final class JavaInterfaces {
  private final Diagnostics diagnostics;

  JavaInterfaces(Diagnostics diagnostics) {
    this.diagnostics = diagnostics;
  }

  /** Plans an interface. Methods that Java cannot express are reported and omitted. */
  Optional<Interface> of(String name, String source, String role, List<Method> methods) {
    if (!JavaNames.isTypeName(name) || JavaNames.isUsedType(name)) {
      diagnostics.error(
          source,
          0,
          "type_name " + name,
          JavaNames.isUsedType(name)
              ? "is reserved for test applications; rename the interface"
              : "is not a valid Java interface name");
      return Optional.empty();
    }
    List<Signature> signatures = new ArrayList<>();
    Set<String> overloads = new HashSet<>();
    for (Method method : methods) {
      signature(source, method, overloads).ifPresent(signatures::add);
    }
    return Optional.of(new Interface(name, source, role, signatures));
  }

  private Optional<Signature> signature(String source, Method method, Set<String> overloads) {
    if (!JavaNames.isName(method.name()) || JavaNames.isObjectMethod(method.name())) {
      inMethod(source, method, "is not a valid Java method name");
      return Optional.empty();
    }
    List<JavaParameter> parameters = parameters(source, method);
    boolean isVoid = method.returnType().isVoid();
    Optional<JavaType> returns = JavaType.of(method.returnType());
    if (!isVoid && returns.isEmpty()) {
      unknown(source, method, "its return type", method.returnType());
      return Optional.empty();
    }
    // Java distinguishes overloads by erased types, which ignore the type argument of Out.
    List<String> erased =
        parameters.stream().map(p -> p.declaration().split("[ <]", 2)[0]).toList();
    if (!overloads.add(method.name() + erased)) {
      inMethod(source, method, "has the same parameters in Java as another overload");
      return Optional.empty();
    }
    return Optional.of(
        new Signature(method.name(), returns.orElse(null), parameters, method.raises()));
  }

  private List<JavaParameter> parameters(String source, Method method) {
    JavaNames scope = new JavaNames();
    List<JavaParameter> parameters = new ArrayList<>();
    for (Parameter parameter : method.parameters()) {
      Optional<JavaType> type = JavaType.of(parameter.type());
      if (type.isEmpty()) {
        unknown(source, method, "parameter " + parameter.name(), parameter.type());
      } else {
        parameters.add(
            new JavaParameter(
                parameter.name(),
                scope.local(parameter.name()),
                type.get(),
                parameter.direction()));
      }
    }
    return parameters;
  }

  private void unknown(String source, Method method, String what, DataType type) {
    inMethod(source, method, what + " is " + type.typeName() + "; " + JavaType.SUPPORTED);
  }

  private void inMethod(String source, Method method, String problem) {
    diagnostics.error(source, method.line(), "method " + method.name(), problem);
  }
}
