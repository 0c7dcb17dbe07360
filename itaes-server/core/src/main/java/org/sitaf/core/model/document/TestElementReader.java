package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.TestElementType;

/** Reads what inputs and outputs have in common: name, kind and type. */
final class TestElementReader {
  private final Problems problems;

  TestElementReader(Problems problems) {
    this.problems = problems;
  }

  <K> Optional<K> kind(TestElementType element, Map<String, K> kinds) {
    Optional<K> kind = Optional.ofNullable(kinds.get(text(element.getType())));
    if (kind.isEmpty()) {
      problems.error(
          XmlDocuments.line(element),
          where(element) + "/type",
          "must be one of "
              + String.join(", ", new TreeSet<>(kinds.keySet()))
              + ", not '"
              + element.getType()
              + "'");
    }
    return kind;
  }

  DataType type(TestElementType element) {
    String where = where(element);
    int line = XmlDocuments.line(element);
    if (name(element).isEmpty()) {
      problems.error(line, where + "/name", "is missing");
    }
    if (element.getRealType() == null) {
      problems.error(line, where, "has no real_type, such as int or double");
      return new DataType.Unknown("");
    }
    DataType type = TypeGrammar.parse(element.getRealType()).type();
    String abstractType = abstractType(element);
    boolean fits =
        switch (abstractType) {
          case "NUMERIC" -> !(type instanceof DataType.Scalar s) || isNumber(s.type());
          case "STRING" ->
              !(type instanceof DataType.Scalar s)
                  || s.type() == ScalarType.STRING
                  || s.type() == ScalarType.CHAR;
          case "BOOLEAN" -> isBoolean(type) || type instanceof DataType.Unknown;
          case "VOID" -> type.isVoid();
          case "ENUM", "STRUCT", "SEQUENCE" -> true;
          default -> {
            problems.error(
                line,
                where,
                "abstract_type must be NUMERIC, STRING, BOOLEAN, ENUM, STRUCT, SEQUENCE or VOID,"
                    + " not '"
                    + element.getAbstractType()
                    + "'");
            yield true;
          }
        };
    if (!fits) {
      problems.error(
          line,
          where,
          "abstract_type "
              + abstractType
              + " and real_type "
              + element.getRealType()
              + " contradict each other");
    }
    return type;
  }

  static boolean isBoolean(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.BOOLEAN;
  }

  static String abstractType(TestElementType element) {
    return text(element.getAbstractType()).toUpperCase(Locale.ROOT);
  }

  static String name(TestElementType element) {
    return text(element.getName());
  }

  static String where(TestElementType element) {
    return "test_element " + name(element);
  }

  private static boolean isNumber(ScalarType type) {
    return type.isNumeric() || type == ScalarType.BOOLEAN;
  }
}
