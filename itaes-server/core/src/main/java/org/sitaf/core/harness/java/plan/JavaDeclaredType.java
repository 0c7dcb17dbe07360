package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan;

/**
 * A struct or an enumeration of the interfaces in Java: a record with a constructor that sets all
 * members to zero, or an enum.
 *
 * @param members members of a record, such as {@code double x}; empty for an enum
 * @param zeros zero values of the members
 * @param literals literals of an enum; empty for a record
 */
public record JavaDeclaredType(
    String name,
    String typeName,
    List<String> members,
    List<String> zeros,
    List<String> literals,
    SortedSet<String> imports) {
  public JavaDeclaredType {
    members = List.copyOf(members);
    zeros = List.copyOf(zeros);
    literals = List.copyOf(literals);
  }

  /** Whether it is an enum. */
  public boolean isEnum() {
    return !literals.isEmpty();
  }

  /** Plans the types, and reports everything that Java cannot express. */
  static List<JavaDeclaredType> of(List<DataType> types, Diagnostics diagnostics) {
    List<JavaDeclaredType> declared = new ArrayList<>();
    for (DataType type : types) {
      String name = HarnessPlan.simpleName(type);
      if (!JavaNames.isTypeName(name) || JavaNames.isUsedType(name)) {
        problem(
            diagnostics,
            type,
            JavaNames.isUsedType(name)
                ? "has a name that is reserved for test applications"
                : "is not a valid Java type name");
      } else if (type instanceof DataType.Struct struct) {
        declared.add(struct(name, struct, diagnostics));
      } else if (type instanceof DataType.Enumeration enumeration) {
        enumeration.literals().stream()
            .filter(l -> !JavaNames.isName(l))
            .forEach(l -> problem(diagnostics, type, l + " is not a valid Java name"));
        declared.add(
            new JavaDeclaredType(
                name,
                type.typeName(),
                List.of(),
                List.of(),
                enumeration.literals(),
                new TreeSet<>()));
      }
    }
    return declared;
  }

  private static JavaDeclaredType struct(
      String name, DataType.Struct struct, Diagnostics diagnostics) {
    List<String> members = new ArrayList<>();
    List<String> zeros = new ArrayList<>();
    SortedSet<String> imports = new TreeSet<>();
    for (DataType.Member member : struct.members()) {
      Optional<JavaType> type = JavaType.of(member.type());
      if (!JavaNames.isName(member.name()) || JavaNames.isObjectMethod(member.name())) {
        problem(diagnostics, struct, member.name() + " is not a valid name of a record component");
      } else if (type.isEmpty()) {
        problem(
            diagnostics,
            struct,
            member.name() + " is " + member.type().typeName() + "; " + JavaType.SUPPORTED);
      } else {
        members.add(type.get().name() + " " + member.name());
        zeros.add(type.get().zero());
        type.get().imports().stream()
            .filter(i -> !i.startsWith(JavaType.INTERFACES + "."))
            .forEach(imports::add);
      }
    }
    return new JavaDeclaredType(name, struct.typeName(), members, zeros, List.of(), imports);
  }

  private static void problem(Diagnostics diagnostics, DataType type, String problem) {
    diagnostics.error("interfaces", 0, "type " + type.typeName(), problem);
  }
}
