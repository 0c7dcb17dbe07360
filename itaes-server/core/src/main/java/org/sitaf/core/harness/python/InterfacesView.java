package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.python.PythonPlan.Stub;
import org.sitaf.core.harness.python.PythonPlan.StubMethod;

/** The views of the package {@code sitaf_interfaces}. */
final class InterfacesView {
  private InterfacesView() {}

  /** A required interface. */
  record Interface(
      String documentation,
      String imports,
      String name,
      String classDocumentation,
      List<String> methods) {
    static Interface of(Stub stub) {
      Imports imports = new Imports().add("typing", "Protocol");
      List<String> methods = new ArrayList<>();
      for (StubMethod method : stub.methods()) {
        var types = new ArrayList<DataType>();
        types.add(method.neutral().method().returnType());
        method.neutral().method().parameters().forEach(p -> types.add(p.type()));
        types.forEach(t -> importDeclared(t, imports));
        methods.add(TestStubView.declaration(method) + " ...");
      }
      String about =
          "The required interface "
              + PythonText.plain(stub.name())
              + ", described in "
              + PythonText.plain(stub.neutral().source())
              + ".";
      return new Interface(
          PythonText.docstring(0, List.of("A required interface of the component.")),
          imports.text(),
          stub.name(),
          PythonText.docstring(4, List.of(about)),
          methods);
    }
  }

  /** Imports types from their module, because the package itself is not initialized yet. */
  private static void importDeclared(DataType type, Imports imports) {
    if (type instanceof DataType.Struct || type instanceof DataType.Enumeration) {
      imports.add("sitaf_interfaces.data_types", HarnessPlan.simpleName(type));
    } else {
      type.parts().forEach(part -> importDeclared(part, imports));
    }
  }

  /** The structs and enumerations. */
  record DataTypes(String imports, List<Declared> types) {
    /** A struct or an enumeration. */
    record Declared(String head, String documentation, List<String> lines) {}

    static DataTypes of(HarnessPlan plan) {
      Imports imports = new Imports();
      List<Declared> declared = new ArrayList<>();
      for (DataType type : plan.types()) {
        if (type instanceof DataType.Struct struct) {
          imports.add("dataclasses", "dataclass").add("sitaf_runtime.suite.kinds", "member");
          struct.members().forEach(m -> importKinds(m.type(), imports));
        } else {
          imports.add("enum", "Enum");
        }
        declared.add(declared(type));
      }
      return new DataTypes(imports.text(), declared);
    }

    private static void importKinds(DataType type, Imports imports) {
      for (String word : PythonType.kind(type).split("\\W+")) {
        if (PythonNames.isUsedType(word)) {
          imports.add("sitaf_runtime.suite.kinds", word);
        }
      }
    }

    private static Declared declared(DataType type) {
      String name = HarnessPlan.simpleName(type);
      List<String> lines = new ArrayList<>();
      if (type instanceof DataType.Struct struct) {
        for (DataType.Member member : struct.members()) {
          lines.add(
              new PythonText.Group(
                      member.name() + ": " + PythonType.hint(member.type()) + " = member(",
                      ")",
                      PythonType.kind(member.type()))
                  .at(4));
        }
        return new Declared(
            "@dataclass\nclass " + name + ":", documentation("The struct ", type), lines);
      }
      List<String> literals = ((DataType.Enumeration) type).literals();
      for (int i = 0; i < literals.size(); i++) {
        lines.add("    " + literals.get(i) + " = " + i);
      }
      return new Declared(
          "class " + name + "(Enum):", documentation("The enumeration ", type), lines);
    }

    private static String documentation(String what, DataType type) {
      return PythonText.docstring(4, List.of(what + PythonText.plain(type.typeName()) + "."));
    }
  }
}
