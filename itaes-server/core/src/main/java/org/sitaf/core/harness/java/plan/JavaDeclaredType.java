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
 * A struct or an enumeration of the interfaces as a Java source: a record with a constructor that
 * makes all of it zero, or an enum.
 *
 * @param members of a record, as {@code double x}; empty for an enum
 * @param zeros of the members
 * @param literals of an enum; empty for a record
 */
public record JavaDeclaredType(
    String name,
    String spelling,
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

  /** The types, with everything told that Java cannot spell. */
  static List<JavaDeclaredType> of(List<DataType> types, Diagnostics diagnostics) {
    List<JavaDeclaredType> declared = new ArrayList<>();
    for (DataType type : types) {
      String name = HarnessPlan.simpleName(type);
      if (!JavaNames.isTypeName(name) || JavaNames.isUsedType(name)) {
        problem(
            diagnostics,
            type,
            JavaNames.isUsedType(name)
                ? "has a name that test applications use themselves"
                : "has no name that a Java type can have");
      } else if (type instanceof DataType.Struct struct) {
        declared.add(struct(name, struct, diagnostics));
      } else if (type instanceof DataType.Enumeration enumeration) {
        enumeration.literals().stream()
            .filter(l -> !JavaNames.isName(l))
            .forEach(l -> problem(diagnostics, type, l + " is not a name in Java"));
        declared.add(
            new JavaDeclaredType(
                name,
                type.spelling(),
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
        problem(
            diagnostics,
            struct,
            member.name() + " is not a name that a member of a record can have");
      } else if (type.isEmpty()) {
        problem(
            diagnostics,
            struct,
            member.name() + " is " + member.type().spelling() + "; " + JavaType.SUPPORTED);
      } else {
        members.add(type.get().name() + " " + member.name());
        zeros.add(type.get().zero());
        type.get().imports().stream()
            .filter(i -> !i.startsWith(JavaType.INTERFACES + "."))
            .forEach(imports::add);
      }
    }
    return new JavaDeclaredType(name, struct.spelling(), members, zeros, List.of(), imports);
  }

  private static void problem(Diagnostics diagnostics, DataType type, String problem) {
    diagnostics.error("interfaces", 0, "type " + type.spelling(), problem);
  }
}
