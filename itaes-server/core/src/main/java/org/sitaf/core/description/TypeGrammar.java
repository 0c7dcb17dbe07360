package org.sitaf.core.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Parses type names: C++ types such as {@code const std::vector< valarray<double> >&}, {@code
 * unsigned int}, {@code uint8_t} or {@code double[3]}, and the canonical names of {@link DataType},
 * including bounds as in {@code string<10>}. A type that cannot be resolved becomes {@link
 * DataType.Unknown} with its original name.
 */
public final class TypeGrammar {
  private static final Map<String, ScalarType> SCALARS =
      Map.ofEntries(
          Map.entry("void", ScalarType.VOID),
          Map.entry("bool", ScalarType.BOOLEAN),
          Map.entry("boolean", ScalarType.BOOLEAN),
          Map.entry("char", ScalarType.CHAR),
          Map.entry("wchar", ScalarType.CHAR),
          Map.entry("wchar_t", ScalarType.CHAR),
          Map.entry("signed char", ScalarType.INT8),
          Map.entry("int8", ScalarType.INT8),
          Map.entry("unsigned char", ScalarType.UINT8),
          Map.entry("uint8", ScalarType.UINT8),
          Map.entry("byte", ScalarType.UINT8),
          Map.entry("octet", ScalarType.UINT8),
          Map.entry("short", ScalarType.INT16),
          Map.entry("short int", ScalarType.INT16),
          Map.entry("int16", ScalarType.INT16),
          Map.entry("unsigned short", ScalarType.UINT16),
          Map.entry("uint16", ScalarType.UINT16),
          Map.entry("int", ScalarType.INT32),
          Map.entry("integer", ScalarType.INT32),
          Map.entry("signed", ScalarType.INT32),
          Map.entry("signed int", ScalarType.INT32),
          Map.entry("int32", ScalarType.INT32),
          Map.entry("unsigned", ScalarType.UINT32),
          Map.entry("unsigned int", ScalarType.UINT32),
          Map.entry("uint", ScalarType.UINT32),
          Map.entry("uint32", ScalarType.UINT32),
          Map.entry("long", ScalarType.INT64),
          Map.entry("long int", ScalarType.INT64),
          Map.entry("long long", ScalarType.INT64),
          Map.entry("int64", ScalarType.INT64),
          Map.entry("unsigned long", ScalarType.UINT64),
          Map.entry("unsigned long long", ScalarType.UINT64),
          Map.entry("uint64", ScalarType.UINT64),
          Map.entry("size_t", ScalarType.UINT64),
          Map.entry("float", ScalarType.FLOAT),
          Map.entry("float32", ScalarType.FLOAT),
          Map.entry("double", ScalarType.DOUBLE),
          Map.entry("float64", ScalarType.DOUBLE),
          Map.entry("real", ScalarType.DOUBLE),
          Map.entry("string", ScalarType.STRING),
          Map.entry("wstring", ScalarType.STRING));

  private static final Set<String> SEQUENCES =
      Set.of("vector", "valarray", "list", "deque", "sequence");

  /** A length or bound. Larger numbers are most likely mistakes. */
  private static final String LENGTH = "[1-9][0-9]{0,5}";

  private static final int MAX_LENGTH = 500;

  private final String text;
  private int at;

  private TypeGrammar(String text) {
    this.text = text;
  }

  /**
   * A parsed type.
   *
   * @param byReference whether it is a non-const reference or pointer, so the callee may write to
   *     it
   */
  public record ParsedType(DataType type, boolean byReference) {}

  /** Parses a type name. Never fails. */
  public static ParsedType parse(String typeText) {
    String flat = typeText.strip().replaceAll("\\s+", " ");
    if (flat.isEmpty() || flat.length() > MAX_LENGTH) {
      return new ParsedType(new DataType.Unknown(flat), false);
    }
    boolean constant = flat.startsWith("const ") || flat.matches(".* const ?[&*]?");
    boolean reference = flat.endsWith("&") || flat.endsWith("*");
    String value =
        flat.replaceAll("^const ", "")
            .replaceAll("( ?const)? ?[&*]+$", "")
            .replaceAll(" const$", "");
    TypeGrammar grammar = new TypeGrammar(value);
    Optional<DataType> type = grammar.type();
    boolean complete = type.isPresent() && grammar.at == grammar.text.length();
    return new ParsedType(
        complete ? type.get() : new DataType.Unknown(value), reference && !constant);
  }

  private Optional<DataType> type() {
    String name = name();
    if (name.isEmpty()) {
      return Optional.empty();
    }
    Optional<DataType> type = take('<') ? template(name) : Optional.of(named(name));
    List<String> dimensions = new ArrayList<>();
    while (type.isPresent() && take('[')) {
      dimensions.add(digits());
      if (!take(']')) {
        return Optional.empty();
      }
    }
    // The last dimension is the innermost.
    for (int i = dimensions.size() - 1; i >= 0 && type.isPresent(); i--) {
      String digits = dimensions.get(i);
      type = digits.isEmpty() ? type.map(e -> new DataType.Sequence(e)) : array(type.get(), digits);
    }
    return type;
  }

  private Optional<DataType> template(String name) {
    if (named(name) instanceof DataType.Scalar scalar && scalar.type() == ScalarType.STRING) {
      OptionalInt bound = bound();
      return bound.isPresent() && take('>')
          ? Optional.of(new DataType.Scalar(ScalarType.STRING, bound.getAsInt()))
          : Optional.empty();
    }
    Optional<DataType> element = type();
    if (element.isEmpty()) {
      return Optional.empty();
    }
    if (name.equals("array")) {
      if (!take(',')) {
        return Optional.empty();
      }
      String digits = digits();
      return take('>') ? array(element.get(), digits) : Optional.empty();
    }
    if (!SEQUENCES.contains(name)) {
      return Optional.empty();
    }
    OptionalInt bound = take(',') ? bound() : OptionalInt.of(0);
    return bound.isPresent() && take('>')
        ? element.map(e -> new DataType.Sequence(e, bound.getAsInt()))
        : Optional.empty();
  }

  private OptionalInt bound() {
    String digits = digits();
    return digits.matches(LENGTH) ? OptionalInt.of(Integer.parseInt(digits)) : OptionalInt.empty();
  }

  private static Optional<DataType> array(DataType element, String digits) {
    return digits.matches(LENGTH)
        ? Optional.of(new DataType.FixedArray(element, Integer.parseInt(digits)))
        : Optional.empty();
  }

  private static DataType named(String name) {
    String plain = name.toLowerCase(Locale.ROOT);
    ScalarType scalar = SCALARS.get(plain);
    if (scalar == null && plain.endsWith("_t")) {
      scalar = SCALARS.get(plain.substring(0, plain.length() - 2));
    }
    return scalar == null ? new DataType.Unknown(name) : new DataType.Scalar(scalar);
  }

  /** Reads words separated by single spaces, without the prefix {@code std::}. */
  private String name() {
    skipSpace();
    int from = at;
    while (at < text.length()
        && (Character.isLetterOrDigit(text.charAt(at)) || "_: ".indexOf(text.charAt(at)) >= 0)) {
      at++;
    }
    return text.substring(from, at).strip().replaceFirst("^(::)?std::", "");
  }

  private String digits() {
    skipSpace();
    int from = at;
    while (at < text.length() && Character.isDigit(text.charAt(at))) {
      at++;
    }
    String digits = text.substring(from, at);
    skipSpace();
    return digits;
  }

  private boolean take(char expected) {
    skipSpace();
    if (at < text.length() && text.charAt(at) == expected) {
      at++;
      skipSpace();
      return true;
    }
    return false;
  }

  private void skipSpace() {
    while (at < text.length() && text.charAt(at) == ' ') {
      at++;
    }
  }
}
