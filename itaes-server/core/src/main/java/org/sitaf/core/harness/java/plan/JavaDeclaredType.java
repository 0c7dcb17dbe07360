package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * A struct or an enumeration of the interfaces in Java: a record with a constructor that sets all
 * members to zero, or an enum.
 *
 * @param members declarations of a record's components, such as {@code double x}; empty for an enum
 * @param zeros zero values of the members
 * @param literals declarations of an enum's constants; empty for a record
 */
public record JavaDeclaredType(
    String name,
    String typeName,
    List<String> members,
    List<String> zeros,
    List<String> literals,
    SortedSet<String> imports) {
  private static final String DOCUMENT_NAME = "org.sitaf.runtime.suite.DocumentName";

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
    JavaNames.DECLARED.check(types, "interfaces", diagnostics);
    List<JavaDeclaredType> declared = new ArrayList<>();
    for (DataType type : types) {
      String name = JavaNames.DECLARED.type(type);
      if (type instanceof DataType.Struct struct) {
        declared.add(struct(name, struct, diagnostics));
      } else if (type instanceof DataType.Enumeration enumeration) {
        declared.add(
            new JavaDeclaredType(
                name,
                type.typeName(),
                List.of(),
                List.of(),
                enumeration.literals().stream()
                    .map(l -> declaration("", JavaNames.DECLARED.literal(l), l))
                    .toList(),
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
      if (type.isEmpty()) {
        problem(
            diagnostics,
            struct,
            member.name() + " is " + member.type().typeName() + "; " + JavaType.SUPPORTED);
      } else {
        String component = JavaNames.DECLARED.member(member.name());
        members.add(declaration(type.get().name() + " ", component, member.name()));
        zeros.add(type.get().zero());
        type.get().imports().stream()
            .filter(i -> !i.startsWith(JavaType.INTERFACES + "."))
            .forEach(imports::add);
      }
    }
    return new JavaDeclaredType(name, struct.typeName(), members, zeros, List.of(), imports);
  }

  /** A declaration with its name in documents, if that is another one. */
  private static String declaration(String type, String name, String documentName) {
    String annotation =
        name.equals(documentName)
            ? ""
            : "@" + DOCUMENT_NAME + "(" + JavaText.string(documentName) + ") ";
    return annotation + type + name;
  }

  private static void problem(Diagnostics diagnostics, DataType type, String problem) {
    diagnostics.error("interfaces", 0, "type " + type.typeName(), problem);
  }
}
