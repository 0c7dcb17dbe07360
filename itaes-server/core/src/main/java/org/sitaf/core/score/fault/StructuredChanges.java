package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.verdict.Literals;

/** Faults of structs and sequences: of all numbers, of one member, of the order, of the length. */
final class StructuredChanges {
  private static final int MAX_PARTS = 8;
  private static final int MAX_DEPTH = 16;

  private StructuredChanges() {}

  static List<ValueChange> of(DataType type) {
    List<ValueChange> changes = new ArrayList<>();
    for (ValueChange each : RealChanges.few(false)) {
      changes.add(
          new ValueChange(
              "all numbers: " + each.text(), literal -> leaves(literal, type, each.text(), 0)));
    }
    if (type instanceof DataType.Struct struct) {
      ofMembers(struct, changes);
    } else {
      ofElements(type, changes);
    }
    return changes;
  }

  private static void ofMembers(DataType.Struct struct, List<ValueChange> changes) {
    List<DataType.Member> members =
        struct.members().subList(0, Math.min(MAX_PARTS, struct.members().size()));
    for (int i = 0; i < members.size(); i++) {
      DataType.Member member = members.get(i);
      for (ValueChange each : ValueChanges.few(member.type())) {
        changes.add(
            new ValueChange(
                "member " + member.name() + ": " + each.text(),
                literal -> member(literal, member.name(), value -> part(value, each))));
      }
      if (i > 0 && members.get(i - 1).type().equals(member.type())) {
        String other = members.get(i - 1).name();
        changes.add(
            new ValueChange(
                "members " + other + " and " + member.name() + " swapped",
                literal -> swapped(literal, other, member.name())));
      }
    }
  }

  private static void ofElements(DataType type, List<ValueChange> changes) {
    DataType element = type.parts().isEmpty() ? new DataType.Unknown("") : type.parts().get(0);
    for (ValueChange each : ValueChanges.few(element)) {
      changes.add(
          new ValueChange(
              "first element: " + each.text(),
              literal ->
                  elements(
                      literal,
                      all -> {
                        if (!all.isEmpty()) {
                          all.set(0, part(all.get(0), each));
                        }
                      })));
    }
    changes.add(
        new ValueChange("order reversed", literal -> elements(literal, Collections::reverse)));
    changes.add(
        new ValueChange(
            "first element moved to the end",
            literal -> elements(literal, all -> Collections.rotate(all, -1))));
    changes.add(
        new ValueChange(
            "first two elements swapped",
            literal ->
                elements(
                    literal,
                    all -> {
                      if (all.size() > 1) {
                        Collections.swap(all, 0, 1);
                      }
                    })));
    if (!(type instanceof DataType.FixedArray)) {
      changes.add(
          new ValueChange(
              "last element lost",
              literal ->
                  elements(
                      literal,
                      all -> {
                        if (!all.isEmpty()) {
                          all.remove(all.size() - 1);
                        }
                      })));
      changes.add(
          new ValueChange(
              "last element twice",
              literal ->
                  elements(
                      literal,
                      all -> {
                        if (!all.isEmpty()) {
                          all.add(all.get(all.size() - 1));
                        }
                      })));
      changes.add(new ValueChange("always empty", literal -> elements(literal, List::clear)));
    }
  }

  /** Changes all numbers; those of an integer type by the fault of the same name, if it has one. */
  private static String leaves(String literal, DataType type, String fault, int depth) {
    if (depth > MAX_DEPTH) {
      return literal;
    }
    try {
      if (Literals.isStruct(literal)) {
        Map<String, String> members = new LinkedHashMap<>(Literals.writtenMembers(literal));
        members.replaceAll((name, value) -> leaves(value, type.member(name), fault, depth + 1));
        return struct(members);
      }
      if (Literals.isSequence(literal)) {
        DataType element = type.parts().isEmpty() ? new DataType.Unknown("") : type.parts().get(0);
        return Literals.writtenElements(literal).stream()
            .map(value -> leaves(value, element, fault, depth + 1))
            .collect(Collectors.joining(", ", "[", "]"));
      }
    } catch (IllegalArgumentException e) {
      return literal;
    }
    if (!Literals.isReal(literal)) {
      return literal;
    }
    return ValueChanges.few(type instanceof DataType.Scalar ? type : ValueChanges.DOUBLE).stream()
        .filter(change -> change.text().equals(fault))
        .findFirst()
        .map(change -> change.apply(literal))
        .orElse(literal);
  }

  /** Changes a part of a value; texts are in quotes there. */
  private static String part(String written, ValueChange change) {
    boolean quoted = written.length() >= 2 && written.startsWith("\"") && written.endsWith("\"");
    if (!quoted) {
      return change.apply(written);
    }
    return written.contains("\\")
        ? written
        : "\"" + change.apply(written.substring(1, written.length() - 1)) + "\"";
  }

  private static String member(String literal, String name, UnaryOperator<String> change) {
    return members(literal, all -> all.computeIfPresent(name, (key, value) -> change.apply(value)));
  }

  private static String swapped(String literal, String one, String other) {
    return members(
        literal,
        all -> {
          if (all.containsKey(one) && all.containsKey(other)) {
            all.put(one, all.put(other, all.get(one)));
          }
        });
  }

  private interface Edit<T> {
    void apply(T parts);
  }

  private static String members(String literal, Edit<Map<String, String>> edit) {
    if (!Literals.isStruct(literal)) {
      return literal;
    }
    try {
      Map<String, String> members = new LinkedHashMap<>(Literals.writtenMembers(literal));
      Map<String, String> before = Map.copyOf(members);
      edit.apply(members);
      return members.equals(before) ? literal : struct(members);
    } catch (IllegalArgumentException e) {
      return literal;
    }
  }

  private static String elements(String literal, Edit<List<String>> edit) {
    if (!Literals.isSequence(literal)) {
      return literal;
    }
    try {
      List<String> elements = new ArrayList<>(Literals.writtenElements(literal));
      List<String> before = List.copyOf(elements);
      edit.apply(elements);
      return elements.equals(before)
          ? literal
          : elements.stream().collect(Collectors.joining(", ", "[", "]"));
    } catch (IllegalArgumentException e) {
      return literal;
    }
  }

  private static String struct(Map<String, String> members) {
    return members.entrySet().stream()
        .map(e -> e.getKey() + ": " + e.getValue())
        .collect(Collectors.joining(", ", "{", "}"));
  }
}
