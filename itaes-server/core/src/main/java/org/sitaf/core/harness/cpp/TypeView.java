package org.sitaf.core.harness.cpp;

import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;

/** The view of a struct, an enumeration or an error. */
record TypeView(
    String name,
    List<String> includes,
    boolean struct,
    boolean enumeration,
    boolean error,
    List<Part> parts) {

  /** A member of a struct, or a literal of an enumeration, with its name in documents. */
  record Part(String type, String documentName, String name, boolean last) {}

  static TypeView of(DataType type) {
    String name = CppNames.DECLARED.type(type);
    if (type instanceof DataType.Struct struct) {
      List<DataType.Member> members = struct.members();
      return new TypeView(
          name,
          new Includes().own("sitaf/suite/value.hpp").types(struct.parts()).lines(),
          true,
          false,
          false,
          members.stream()
              .map(
                  m ->
                      new Part(
                          CppType.within(m.type()),
                          m.name(),
                          CppNames.DECLARED.member(m.name()),
                          m == members.get(members.size() - 1)))
              .toList());
    }
    List<String> literals = ((DataType.Enumeration) type).literals();
    return new TypeView(
        name,
        new Includes()
            .standard("array", "string_view", "utility")
            .own("sitaf/suite/value.hpp")
            .lines(),
        false,
        true,
        false,
        literals.stream()
            .map(
                l ->
                    new Part(
                        "",
                        l,
                        CppNames.DECLARED.literal(l),
                        l.equals(literals.get(literals.size() - 1))))
            .toList());
  }

  static TypeView ofError(String name) {
    return new TypeView(
        name, new Includes().standard("stdexcept").lines(), false, false, true, List.of());
  }

  /** The declaration of the enumeration. */
  String declaration() {
    return CppText.list(
        "enum class " + name + " { ", parts.stream().map(Part::name).toList(), " };");
  }

  /** The number of literals of an enumeration. */
  int count() {
    return parts.size();
  }

  /** Double braces, which the template engine would interpret. */
  String open() {
    return "{{";
  }

  String close() {
    return "}}";
  }
}
