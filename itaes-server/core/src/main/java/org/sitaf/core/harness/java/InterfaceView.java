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
    String documentation,
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
        JavaText.javadoc(
            0,
            List.of(
                "The "
                    + described.role()
                    + " interface "
                    + JavaText.comment(described.name())
                    + ", described in "
                    + JavaText.comment(described.source())
                    + "."),
            List.of()),
        described.methods().stream().map(InterfaceView::declaration).toList());
  }

  private static String declaration(Signature method) {
    String errors =
        method.errors().isEmpty() ? "" : " throws " + String.join(", ", method.errors());
    return JavaText.declaration(
        2,
        method.returnName() + " " + method.name(),
        method.parameters().stream().map(p -> p.declaration()).toList(),
        false,
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
