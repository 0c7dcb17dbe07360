package org.sitaf.core.harness.java;

import java.util.List;
import java.util.SortedSet;
import org.sitaf.core.harness.java.plan.JavaDeclaredType;
import org.sitaf.core.harness.java.plan.JavaText;

/** The view of a struct or an enumeration. */
record DeclaredTypeView(
    String name,
    boolean hasImports,
    SortedSet<String> imports,
    String documentation,
    boolean isEnum,
    boolean hasMembers,
    String head,
    String zero,
    List<String> literals) {

  static DeclaredTypeView of(JavaDeclaredType type) {
    return new DeclaredTypeView(
        type.name(),
        !type.imports().isEmpty(),
        type.imports(),
        JavaText.javadoc(
            0,
            List.of(
                "The type "
                    + JavaText.comment(type.typeName())
                    + " of the component's interfaces."),
            List.of()),
        type.isEnum(),
        !type.members().isEmpty(),
        JavaText.declaration(0, "public record " + type.name(), type.members(), false, " {"),
        JavaText.call(4, "", "this", type.zeros()),
        separated(type.literals()));
  }

  private static List<String> separated(List<String> literals) {
    return java.util.stream.IntStream.range(0, literals.size())
        .mapToObj(i -> "  " + literals.get(i) + (i < literals.size() - 1 ? "," : ""))
        .toList();
  }
}
