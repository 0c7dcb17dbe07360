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
    String typeName,
    boolean isEnum,
    boolean hasMembers,
    String members,
    String zeros,
    List<String> literals) {

  static DeclaredTypeView of(JavaDeclaredType type) {
    return new DeclaredTypeView(
        type.name(),
        !type.imports().isEmpty(),
        type.imports(),
        JavaText.comment(type.typeName()),
        type.isEnum(),
        !type.members().isEmpty(),
        String.join(", ", type.members()),
        String.join(", ", type.zeros()),
        type.literals());
  }
}
