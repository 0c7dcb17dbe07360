package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.HarnessPlan;

/** The view of an adapter skeleton. */
record AdapterView(
    String file,
    boolean hasNamespace,
    String namespace,
    List<String> includes,
    String name,
    String bases,
    String constructor,
    List<String> declarations,
    List<String> fields,
    boolean answers,
    boolean hasPrivate,
    String constructorBody,
    List<String> definitions) {

  static AdapterView of(HarnessPlan.Adapter plan) {
    int colon = plan.className().lastIndexOf("::");
    String name = plan.className().substring(colon < 0 ? 0 : colon + 2);
    Includes includes = new Includes();
    List<DataType> types = new ArrayList<>();
    Set<String> written = new HashSet<>();
    List<String> declarations = new ArrayList<>();
    List<String> definitions = new ArrayList<>();
    for (InterfaceDescription provided : plan.provided()) {
      if (!plan.answers()) {
        includes.own("sitaf/interfaces/" + provided.name() + ".hpp");
      }
      for (Method method : provided.methods()) {
        types.add(method.returnType());
        method.parameters().forEach(p -> types.add(p.type()));
        method.raises().forEach(e -> includes.own("sitaf/interfaces/" + e + ".hpp"));
        // A method of several interfaces is implemented once.
        if (written.add(method.name() + "(" + method.signature())) {
          declarations.add(head("", method, plan.answers() ? ");" : ") override;"));
          definitions.add(definition(name, method, plan.answers()));
        }
      }
    }
    List<String> parameters = new ArrayList<>();
    List<String> fields = new ArrayList<>();
    List<String> initialisers = new ArrayList<>();
    if (plan.hardware()) {
      includes.own("sitaf/hardware.hpp");
      parameters.add("sitaf::Hardware& hardware");
      fields.add("sitaf::Hardware& hardware_;");
      initialisers.add("hardware_(hardware)");
    }
    CppNames scope = new CppNames();
    for (String required : plan.required()) {
      includes.own("sitaf/interfaces/" + required + ".hpp");
      String local = scope.local(required);
      parameters.add("sitaf::interfaces::" + required + "& " + local);
      fields.add("sitaf::interfaces::" + required + "& " + local + "_;");
      initialisers.add(local + "_(" + local + ")");
    }
    String explicit = parameters.size() == 1 ? "explicit " : "";
    return new AdapterView(
        fileName(name),
        colon >= 0,
        colon < 0 ? "" : plan.className().substring(0, colon),
        includes.types(types).lines(),
        name,
        plan.answers()
            ? ""
            : " : "
                + plan.provided().stream()
                    .map(p -> "public sitaf::interfaces::" + p.name())
                    .collect(Collectors.joining(", ")),
        CppText.list(explicit + name + "(", parameters, ");"),
        declarations,
        fields,
        plan.answers(),
        !fields.isEmpty() || !plan.answers(),
        CppText.list(name + "::" + name + "(", parameters, ")")
            + (initialisers.isEmpty() ? "" : " : " + String.join(", ", initialisers))
            + " {",
        definitions);
  }

  /** The file of {@code KdlAdapter} is {@code kdl_adapter.hpp}. */
  private static String fileName(String name) {
    return name.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
  }

  private static String head(String scope, Method method, String tail) {
    CppNames names = new CppNames();
    return CppText.list(
        CppType.outside(method.returnType()) + " " + scope + method.name() + "(",
        method.parameters().stream()
            .map(p -> CppType.outsideParameter(p, names.local(p.name())))
            .toList(),
        tail);
  }

  private static String definition(String name, Method method, boolean answers) {
    String errors =
        method.raises().isEmpty()
            ? ""
            : "\n  // May throw exceptions of sitaf::interfaces: "
                + String.join(", ", method.raises())
                + ".";
    if (answers) {
      return head(name + "::", method, ") {")
          + "\n  // Write the method here."
          + errors
          + unused(method)
          + (method.returnType().isVoid() ? "" : "\n  return {};")
          + "\n}";
    }
    return head(name + "::", method, ") {")
        + "\n  // Delegate the call to the component"
        + (method.returnType().isVoid() ? "." : " and return its result.")
        + errors
        + "\n  throw std::logic_error("
        + CppText.string(method.name() + " is not implemented yet")
        + ");\n}";
  }

  /** Keeps the compiler from warning about parameters that the skeleton does not use. */
  private static String unused(Method method) {
    CppNames names = new CppNames();
    return method.parameters().stream()
        .map(p -> "\n  static_cast<void>(" + names.local(p.name()) + ");")
        .collect(Collectors.joining());
  }
}
