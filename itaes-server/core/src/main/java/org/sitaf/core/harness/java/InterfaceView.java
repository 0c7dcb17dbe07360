package org.sitaf.core.harness.java;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.java.plan.JavaPlan.Interface;
import org.sitaf.core.harness.java.plan.JavaPlan.Signature;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;

/** The view of an interface. */
record InterfaceView(
    String name,
    boolean hasImports,
    SortedSet<String> imports,
    String role,
    String described,
    String source,
    List<String> methods) {

  static InterfaceView of(Interface described) {
    SortedSet<String> imports = new TreeSet<>();
    described.methods().forEach(m -> addTypes(m, imports));
    // Types of the same package need no import.
    imports.removeIf(i -> i.startsWith(JavaType.INTERFACES + "."));
    return new InterfaceView(
        described.name(),
        !imports.isEmpty(),
        imports,
        described.role(),
        JavaText.comment(described.name()),
        JavaText.comment(described.source()),
        described.methods().stream().map(InterfaceView::declaration).toList());
  }

  private static String declaration(Signature method) {
    String errors =
        method.errors().isEmpty() ? "" : " throws " + String.join(", ", method.errors());
    return JavaText.declaration(
        method.returnName() + " " + method.name(),
        method.parameters().stream().map(p -> p.declaration()).toList(),
        errors + ";");
  }

  /** Adds the imports of the types of a method. */
  static void addTypes(Signature method, SortedSet<String> imports) {
    if (method.returns() != null) {
      imports.addAll(method.returns().imports());
    }
    method.parameters().forEach(p -> imports.addAll(p.type().imports()));
    if (method.parameters().stream().anyMatch(p -> p.direction() != Direction.IN)) {
      imports.add("org.sitaf.runtime.Out");
    }
  }
}
