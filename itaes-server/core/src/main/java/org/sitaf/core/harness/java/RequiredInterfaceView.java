package org.sitaf.core.harness.java;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.harness.java.plan.JavaPlan.Stub;
import org.sitaf.core.harness.java.plan.JavaText;

/** What the template of a required interface prints. */
record RequiredInterfaceView(
    String name,
    boolean hasImports,
    SortedSet<String> imports,
    String documentation,
    List<String> methods) {

  static RequiredInterfaceView of(Stub stub) {
    SortedSet<String> imports = new TreeSet<>();
    addTypes(stub, imports);
    return new RequiredInterfaceView(
        stub.name(),
        !imports.isEmpty(),
        imports,
        JavaText.javadoc(
            0,
            List.of(
                "The required interface "
                    + JavaText.comment(stub.name())
                    + ", as "
                    + JavaText.comment(stub.source())
                    + " describes it."),
            List.of()),
        stub.methods().stream()
            .map(
                m ->
                    JavaText.declaration(
                        2, m.returnName() + " " + m.name(), m.parameters(), false, ";"))
            .toList());
  }

  /** What the methods' types need. */
  static void addTypes(Stub stub, SortedSet<String> imports) {
    boolean wide =
        stub.methods().stream()
            .anyMatch(
                m ->
                    m.returnName().startsWith("BigInteger")
                        || m.parameters().stream().anyMatch(p -> p.contains("BigInteger")));
    if (wide) {
      imports.add("java.math.BigInteger");
    }
    if (stub.methods().stream()
        .anyMatch(m -> m.parameters().stream().anyMatch(p -> p.startsWith("Out<")))) {
      imports.add("org.sitaf.runtime.Out");
    }
  }
}
