package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Settings.number;
import static org.sitaf.core.model.document.Settings.parseBoolean;
import static org.sitaf.core.model.document.Settings.requireNumeric;
import static org.sitaf.core.model.document.Settings.required;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.schemas.EquivClassType;
import org.sitaf.schemas.TestSpecType;

/** Reads the {@code equiv_class} of a specification. */
final class EquivalenceClassReader {
  private EquivalenceClassReader() {}

  static EquivalenceClass read(TestSpecType spec, DataType type) {
    if (spec.getEquivClass().size() != 1) {
      throw new IllegalArgumentException(
          "needs exactly one equiv_class, not " + spec.getEquivClass().size());
    }
    EquivClassType given = spec.getEquivClass().get(0);
    String kind = String.valueOf(given.getType()).replace("_BOUDARY", "_BOUNDARY");
    if (!kind.equals("NEC_BOOLEAN")) {
      requireNumeric(type);
    }
    requireUsed(
        given,
        kind,
        switch (kind) {
          case "NEC_NUMERIC_ONE_BOUNDARY" ->
              given.getMin() != null
                  ? Set.of("min", "max", "min_inclusive")
                  : Set.of("min", "max", "max_inclusive");
          case "NEC_NUMERIC_TWO_BOUNDARY" -> Set.of("min", "max", "min_inclusive", "max_inclusive");
          case "NEC_BOOLEAN" -> Set.of("value_only");
          case "NEC_NUMERIC_CONSTANT" -> Set.of("value");
          case "NEC_NUMERIC_SET" -> Set.of("<value>");
          default ->
              Set.of(
                  "min", "max", "min_inclusive", "max_inclusive", "value", "value_only", "<value>");
        });
    return switch (kind) {
      case "NEC_NUMERIC_ONE_BOUNDARY" -> oneBoundary(given, type);
      case "NEC_NUMERIC_TWO_BOUNDARY" ->
          new EquivalenceClass.TwoBoundary(
              number(required(given.getMin(), kind + " needs min and max"), type),
              number(required(given.getMax(), kind + " needs min and max"), type),
              parseBoolean(given.getMinInclusive(), true),
              parseBoolean(given.getMaxInclusive(), true));
      case "NEC_BOOLEAN" ->
          new EquivalenceClass.BooleanClass(parseBoolean(given.getValueOnly(), false));
      case "NEC_NUMERIC_CONSTANT" ->
          new EquivalenceClass.Constant(
              number(required(given.getValue(), kind + " needs a value"), type));
      case "NEC_NUMERIC_SET" ->
          new EquivalenceClass.NumericSet(
              given.getValues().stream().map(v -> number(v, type)).toList());
      default ->
          throw new IllegalArgumentException(
              "equiv_class type must be NEC_NUMERIC_ONE_BOUNDARY, NEC_NUMERIC_TWO_BOUNDARY,"
                  + " NEC_BOOLEAN, NEC_NUMERIC_CONSTANT or NEC_NUMERIC_SET, not '"
                  + given.getType()
                  + "'");
    };
  }

  private static EquivalenceClass oneBoundary(EquivClassType given, DataType type) {
    if ((given.getMin() == null) == (given.getMax() == null)) {
      throw new IllegalArgumentException("NEC_NUMERIC_ONE_BOUNDARY has exactly one of min and max");
    }
    boolean lower = given.getMin() != null;
    return new EquivalenceClass.OneBoundary(
        number(lower ? given.getMin() : given.getMax(), type),
        lower,
        lower
            ? parseBoolean(given.getMinInclusive(), true)
            : parseBoolean(given.getMaxInclusive(), true));
  }

  /** Refuses entries that the kind of class does not use. */
  private static void requireUsed(EquivClassType given, String kind, Set<String> used) {
    Map<String, @Nullable Object> entries = new LinkedHashMap<>();
    entries.put("min", given.getMin());
    entries.put("max", given.getMax());
    entries.put("min_inclusive", given.getMinInclusive());
    entries.put("max_inclusive", given.getMaxInclusive());
    entries.put("value", given.getValue());
    entries.put("value_only", given.getValueOnly());
    entries.put("<value>", given.getValues().isEmpty() ? null : given.getValues());
    entries.forEach(
        (name, value) -> {
          if (value != null && !used.contains(name)) {
            throw new IllegalArgumentException(name + " has no effect in " + kind + "; remove it");
          }
        });
  }
}
