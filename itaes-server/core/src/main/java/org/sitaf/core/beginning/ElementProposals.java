package org.sitaf.core.beginning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.beginning.ModelProposal.Xml;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.DataType.Member;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.ScalarType;

/** Proposes the test elements of the parameters of one method, with a specification for each. */
final class ElementProposals {
  /** Members of large messages beyond this number keep the default of their type. */
  private static final int MAX_ELEMENTS = 12;

  /** A node may have several topics, each with a message; a scan alone has nine members. */
  private static final int MAX_ELEMENTS_OF_NODE = 20;

  private static final int MAX_DEPTH = 6;

  /** Set by transport, not by the caller's intent. */
  private static final Set<String> PASSED_OVER = Set.of("header", "stamp");

  private final Map<String, Object> constants;
  private final boolean isNode;
  private final List<String> lines = new ArrayList<>();
  private int count;
  private int cases;

  /**
   * @param isNode whether the parameters are messages of a ROS 2 node, whose lists of numbers
   *     matter
   */
  ElementProposals(Map<String, Object> constants, boolean isNode) {
    this.isNode = isNode;
    this.constants = ModelProposal.shortNames(constants);
  }

  /** The elements of all parameters that a method reads. */
  static ElementProposals ofInputs(Method method, Map<String, Object> constants, boolean isNode) {
    ElementProposals inputs = new ElementProposals(constants, isNode);
    method.parameters().stream()
        .filter(p -> p.direction() != Direction.OUT)
        .forEach(p -> inputs.add(p.name(), p.type()));
    return inputs;
  }

  List<String> lines() {
    return lines;
  }

  /** The number of elements. */
  int count() {
    return count;
  }

  /** A number of cases that holds each value at least once. */
  int cases() {
    return cases;
  }

  /** Adds the elements of a parameter; at least one, because each parameter needs one. */
  void add(String name, DataType type) {
    int before = count;
    propose(name, name, type, 0);
    if (count == before) {
      values(name, type, List.of(Literals.zero(type)), "its other members have default values");
    }
  }

  private void propose(String path, String name, DataType type, int depth) {
    if (count >= (isNode ? MAX_ELEMENTS_OF_NODE : MAX_ELEMENTS) && depth > 0) {
      return;
    }
    if (type instanceof DataType.Scalar scalar) {
      scalar(path, name, scalar.type(), scalar.bound());
    } else if (type instanceof DataType.Enumeration enumeration) {
      values(path, type, enumeration.literals(), "every literal");
    } else if (type instanceof DataType.Struct struct) {
      struct(path, name, struct, depth);
    } else if (depth == 0 || (isNode && hasScalars(type))) {
      values(path, type, Literals.lists(type), "empty, short and longer");
    }
  }

  private static boolean hasScalars(DataType type) {
    return type instanceof DataType.Sequence sequence
        && sequence.element() instanceof DataType.Scalar;
  }

  private void struct(String path, String name, DataType.Struct struct, int depth) {
    if (isQuaternion(struct)) {
      element(
          path,
          struct,
          List.of("<test_spec type=\"ROTATION\" count=\"24\"/>"),
          "whole rotations; those that are no unit quaternions are not among them",
          24);
      return;
    }
    if (isPose(struct)) {
      element(
          path,
          struct,
          List.of("<test_spec type=\"POSE\" count=\"24\" min=\"-1\" max=\"1\"/>"),
          "whole poses, coordinates in metres",
          24);
      return;
    }
    if (isVector(struct)
        && NumberRange.words(name).stream()
            .anyMatch(w -> Set.of("direction", "axis", "normal").contains(w))) {
      element(path, struct, List.of("<test_spec type=\"DIRECTION\"/>"), "unit vectors", 26);
      return;
    }
    if (depth >= MAX_DEPTH) {
      return;
    }
    for (Member member : struct.members()) {
      if (!PASSED_OVER.contains(member.name())) {
        // A coordinate of an angle is an angle, but a coordinate of a point says nothing itself.
        String telling = member.name().length() > 1 ? member.name() : name;
        propose(path + "." + member.name(), telling, member.type(), depth + 1);
      }
    }
  }

  private void scalar(String path, String name, ScalarType type, int bound) {
    DataType.Scalar whole = new DataType.Scalar(type, bound);
    switch (type) {
      case VOID -> {}
      case BOOLEAN ->
          element(
              path,
              whole,
              List.of(
                  "<test_spec type=\"ECP\">",
                  "  <equiv_class type=\"NEC_BOOLEAN\"/>",
                  "</test_spec>"),
              "",
              2);
      case CHAR -> values(path, whole, List.of("a", "Z", "0"), "a letter, a capital, a digit");
      case STRING -> {
        int longest = bound == 0 ? 10 : Math.min(10, bound);
        element(
            path,
            whole,
            List.of(
                "<test_spec type=\"RANDOM_STRING\" min_length=\"0\" max_length=\""
                    + longest
                    + "\" alphabet=\"true\" number=\"true\"/>"),
            "random letters and digits; list real ones in a <user_value_list>",
            8);
      }
      default -> number(path, name, whole);
    }
  }

  private void number(String path, String name, DataType.Scalar type) {
    List<Map.Entry<String, Object>> choices = type.type().isInteger() ? choices(name) : List.of();
    if (!choices.isEmpty()) {
      List<String> content = new ArrayList<>();
      content.add("<test_spec type=\"ECP\" representatives=\"" + choices.size() + "\">");
      content.add("  <equiv_class type=\"NEC_NUMERIC_SET\">");
      choices.forEach(c -> content.add("    <value>" + c.getValue() + "</value>"));
      content.add("  </equiv_class>");
      content.add("</test_spec>");
      String names = choices.stream().map(Map.Entry::getKey).collect(Collectors.joining(", "));
      element(path, type, content, "the constants " + names, choices.size() + 2);
      return;
    }
    NumberRange range = NumberRange.of(name, type.type());
    element(
        path,
        type,
        List.of(
            "<test_spec type=\"BVA\" offset=\"" + range.offset() + "\">",
            "  <equiv_class type=\"NEC_NUMERIC_TWO_BOUNDARY\" min=\""
                + range.min()
                + "\" max=\""
                + range.max()
                + "\"/>",
            "</test_spec>"),
        "assumed: " + range.reason(),
        7);
  }

  /** The integer constants that are named after a parameter: {@code MODE_FAST} of {@code mode}. */
  private List<Map.Entry<String, Object>> choices(String name) {
    Set<String> words = new HashSet<>(NumberRange.words(name));
    Set<Object> seen = new HashSet<>();
    return constants.entrySet().stream()
        .filter(e -> e.getValue() instanceof Long)
        .filter(e -> e.getKey().indexOf('_') > 0)
        .filter(e -> words.contains(NumberRange.words(e.getKey()).get(0)))
        .filter(e -> seen.add(e.getValue()))
        .toList();
  }

  private void values(String path, DataType type, List<String> values, String comment) {
    List<String> content = new ArrayList<>(List.of("<user_value_list>"));
    values.forEach(v -> content.add("  <value>" + Xml.text(v) + "</value>"));
    content.add("</user_value_list>");
    element(path, type, content, comment, values.size());
  }

  private void element(
      String path, DataType type, List<String> content, String comment, int values) {
    count++;
    cases += values;
    if (!comment.isEmpty()) {
      lines.add("<!-- " + Xml.comment(path + ": " + comment) + " -->");
    }
    lines.add(head(type));
    lines.add("  <name>" + Xml.text(path) + "</name>");
    lines.add("  <type>TDI</type>");
    content.forEach(l -> lines.add("  " + l));
    lines.add("</test_element>");
  }

  /** The start tag of an element of this type. */
  static String head(DataType type) {
    return "<test_element abstract_type="
        + Xml.attribute(abstractType(type))
        + " real_type="
        + Xml.attribute(type.typeName())
        + ">";
  }

  private static String abstractType(DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "VOID";
        case BOOLEAN -> "BOOLEAN";
        case STRING -> "STRING";
        case CHAR -> "CHAR";
        default -> "NUMERIC";
      };
    }
    if (type instanceof DataType.Enumeration) {
      return "ENUM";
    }
    return type instanceof DataType.Struct ? "STRUCT" : "SEQUENCE";
  }

  private static boolean isQuaternion(DataType.Struct struct) {
    return hasMembers(struct, Set.of("x", "y", "z", "w")) && isFloating(struct);
  }

  private static boolean isVector(DataType.Struct struct) {
    return hasMembers(struct, Set.of("x", "y", "z")) && isFloating(struct);
  }

  private static boolean isPose(DataType.Struct struct) {
    return hasMembers(struct, Set.of("position", "orientation"))
        && struct.member("position") instanceof DataType.Struct position
        && isVector(position)
        && struct.member("orientation") instanceof DataType.Struct orientation
        && isQuaternion(orientation);
  }

  private static boolean hasMembers(DataType.Struct struct, Set<String> names) {
    return struct.members().stream().map(Member::name).collect(Collectors.toSet()).equals(names);
  }

  private static boolean isFloating(DataType.Struct struct) {
    return struct.parts().stream()
        .allMatch(t -> t instanceof DataType.Scalar scalar && scalar.type().isFloating());
  }
}
