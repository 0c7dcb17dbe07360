package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.Direction;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.JavaPlan.Interface;
import org.sitaf.core.harness.java.plan.JavaPlan.JavaParameter;
import org.sitaf.core.harness.java.plan.JavaPlan.Signature;
import org.sitaf.core.harness.java.plan.JavaPlanner;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;
import org.sitaf.core.harness.plan.HarnessPlan;

/** The view of an adapter skeleton. */
record AdapterView(
    String packageName,
    SortedSet<String> imports,
    boolean answers,
    String name,
    String interfaces,
    String constructor,
    List<String> methods) {

  private static final String HARDWARE = "org.sitaf.runtime.Hardware";

  static AdapterView of(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    List<Interface> interfaces = JavaPlanner.interfaces(plan, diagnostics);
    int dot = plan.className().lastIndexOf('.');
    String name = plan.className().substring(dot + 1);
    SortedSet<String> imports = new TreeSet<>();
    List<String> methods = new ArrayList<>();
    Set<String> written = new HashSet<>();
    for (Interface provided : interfaces) {
      if (!plan.answers()) {
        imports.add(JavaType.INTERFACES + "." + provided.name());
      }
      for (Signature method : provided.methods()) {
        InterfaceView.addTypes(method, imports);
        method.errors().forEach(e -> imports.add(JavaType.INTERFACES + "." + e));
        // A method of several interfaces is implemented once.
        if (written.add(method.name() + method.parameters().stream().map(p -> p.type()).toList())) {
          methods.add(method(method, plan.answers()));
        }
      }
    }
    plan.required().forEach(r -> imports.add(JavaType.INTERFACES + "." + r));
    if (plan.hardware()) {
      imports.add(HARDWARE);
    }
    List<String> interfaceNames = interfaces.stream().map(Interface::name).toList();
    return new AdapterView(
            dot < 0 ? "" : plan.className().substring(0, dot),
            imports,
            plan.answers(),
            name,
            plan.answers() ? "" : " implements " + String.join(", ", interfaceNames),
            constructor(name, plan),
            methods)
        .withoutImportOf(name);
  }

  /** A type with the name of the adapter cannot be imported; its qualified name is used instead. */
  private AdapterView withoutImportOf(String simpleName) {
    Optional<String> same =
        imports.stream().filter(imported -> imported.endsWith("." + simpleName)).findFirst();
    if (same.isEmpty()) {
      return this;
    }
    SortedSet<String> others = new TreeSet<>(imports);
    others.remove(same.get());
    Pattern type = Pattern.compile("(?<![.\\w\"])" + Pattern.quote(simpleName) + "(?![\\w(\"])");
    UnaryOperator<String> qualified =
        text -> type.matcher(text).replaceAll(Matcher.quoteReplacement(same.get()));
    return new AdapterView(
        packageName,
        others,
        answers,
        name,
        qualified.apply(interfaces),
        qualified.apply(constructor),
        methods.stream().map(qualified).toList());
  }

  private static String constructor(String name, HarnessPlan.Adapter plan) {
    List<String> parameters = new ArrayList<>();
    if (plan.hardware()) {
      parameters.add("Hardware hardware");
    }
    for (String required : plan.required()) {
      parameters.add(required + " " + JavaPlanner.local(required));
    }
    return JavaText.declaration("  public " + name, parameters, " {")
        + (plan.answers() ? "" : "\n    // Create the component here and store it in a field.")
        + (plan.hardware() ? "\n    // The hardware gives access to the simulated devices." : "")
        + (plan.required().isEmpty()
            ? ""
            : "\n    // The required interfaces are implemented by the test stub.")
        + "\n  }";
  }

  private static String method(Signature method, boolean answers) {
    String errors =
        method.errors().isEmpty() ? "" : " throws " + String.join(", ", method.errors());
    return (answers ? "" : "  @Override\n")
        + JavaText.declaration(
            "  public " + method.returnName() + " " + method.name(),
            method.parameters().stream().map(JavaParameter::declaration).toList(),
            errors + " {")
        + (answers ? zeros(method) : notWritten(method))
        + "\n  }";
  }

  private static String zeros(Signature method) {
    StringBuilder body = new StringBuilder("\n    // Write the method here.");
    for (JavaParameter parameter : method.parameters()) {
      if (parameter.direction() == Direction.OUT) {
        body.append("\n    " + parameter.local() + ".set(" + parameter.type().zero() + ");");
      }
    }
    if (method.returns() != null) {
      body.append("\n    return " + method.returns().zero() + ";");
    }
    return body.toString();
  }

  private static String notWritten(Signature method) {
    boolean outs = method.parameters().stream().anyMatch(p -> p.declaration().startsWith("Out<"));
    return "\n    // Delegate the call to the component"
        + (method.returns() == null ? "" : " and return its result")
        + (outs ? ".\n    // Set out-parameters by set()." : ".")
        + "\n    throw new UnsupportedOperationException("
        + JavaText.string(method.name() + " is not implemented yet")
        + ");";
  }
}
