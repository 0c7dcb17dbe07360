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
      String imports, String name, String described, String source, List<String> methods) {
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
      return new Interface(
          imports.text(),
          stub.name(),
          PythonText.plain(stub.name()),
          PythonText.plain(stub.neutral().source()),
          methods);
    }
  }

  /** Imports types from their module, because the package itself is not initialized yet. */
  private static void importDeclared(DataType type, Imports imports) {
    if (type instanceof DataType.Struct || type instanceof DataType.Enumeration) {
      imports.add("sitaf_interfaces.data_types", PythonNames.DECLARED.type(type));
    } else {
      type.parts().forEach(part -> importDeclared(part, imports));
    }
  }

  /** The structs and enumerations. */
  record DataTypes(String imports, List<Declared> types) {
    /** A struct or an enumeration. */
    record Declared(boolean struct, String name, String typeName, List<String> lines) {}

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
      String name = PythonNames.DECLARED.type(type);
      List<String> lines = new ArrayList<>();
      if (type instanceof DataType.Struct struct) {
        for (DataType.Member member : struct.members()) {
          String attribute = PythonNames.DECLARED.member(member.name());
          List<String> arguments = new ArrayList<>(List.of(PythonType.kind(member.type())));
          if (!attribute.equals(member.name())) {
            arguments.add(PythonText.string(member.name()));
          }
          lines.add(
              PythonText.list(
                  attribute + ": " + PythonType.hint(member.type()) + " = member(",
                  arguments,
                  ")"));
        }
        return new Declared(true, name, PythonText.plain(type.typeName()), lines);
      }
      List<String> literals = ((DataType.Enumeration) type).literals();
      for (int i = 0; i < literals.size(); i++) {
        String literal = literals.get(i);
        String attribute = PythonNames.DECLARED.literal(literal);
        if (!attribute.equals(literal)) {
          // The literal has its own name; the attribute is an alias that sources can use.
          lines.add("locals()[" + PythonText.string(literal) + "] = " + i);
        }
        lines.add(attribute + " = " + i);
      }
      return new Declared(false, name, PythonText.plain(type.typeName()), lines);
    }
  }
}
