package org.sitaf.core.model.document;

import jakarta.xml.bind.JAXBElement;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.Decimals;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.TestSpec.Distribution;
import org.sitaf.core.model.TestSpec.WeightedRange;
import org.sitaf.schemas.EquivClassType;
import org.sitaf.schemas.TestSpecType;
import org.sitaf.schemas.WeightedRangeType;

/**
 * Reads one {@code test_spec}. Problems are reported with the name of the element and of the entry.
 */
final class TestSpecReader {
  private static final int MAX_COUNT = 1_000_000;

  private final Problems problems;
  private final String where;
  private int line;

  TestSpecReader(Problems problems, String where) {
    this.problems = problems;
    this.where = where;
  }

  /**
   * Returns empty if a problem was reported. All entries are checked, so all problems are reported
   * at once.
   */
  Optional<TestSpec> read(TestSpecType spec, DataType type) {
    line = XmlDocuments.line(spec);
    return switch (String.valueOf(spec.getType())) {
      case "ECP" -> partitioning(spec, type);
      case "BVA" -> boundaries(spec, type);
      case "RANDOM" -> randomNumbers(spec, type);
      case "RANDOM_STRING" -> randomStrings(spec, type);
      default -> {
        problems.error(
            line,
            where,
            "type must be ECP, BVA, RANDOM or RANDOM_STRING, not '" + spec.getType() + "'");
        yield Optional.empty();
      }
    };
  }

  private Optional<TestSpec> partitioning(TestSpecType spec, DataType type) {
    var declared = attempt("equiv_class", () -> equivalenceClass(spec, type));
    var representatives =
        attempt(
            "representatives",
            () ->
                whole(first(spec.getRepresentatives(), spec.getRepresentativesElement(), "1"), 1));
    var offset =
        attempt(
            "offset", () -> positive(first(spec.getOffset(), spec.getOffsetElement(), "1"), type));
    return declared.isEmpty() || representatives.isEmpty() || offset.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new TestSpec.EquivalencePartitioning(
                declared.get(), representatives.get(), offset.get()));
  }

  private Optional<TestSpec> boundaries(TestSpecType spec, DataType type) {
    var declared =
        attempt(
            "equiv_class",
            () -> {
              EquivalenceClass given = equivalenceClass(spec, type);
              if (given instanceof EquivalenceClass.OneBoundary
                  || given instanceof EquivalenceClass.TwoBoundary) {
                return given;
              }
              throw new IllegalArgumentException(
                  "BVA needs NEC_NUMERIC_ONE_BOUNDARY or NEC_NUMERIC_TWO_BOUNDARY");
            });
    var offset =
        attempt(
            "offset",
            () ->
                positive(
                    required(
                        first(spec.getOffset(), spec.getOffsetElement()),
                        "is missing; BVA needs an offset greater than 0"),
                    type));
    var special = attempt("special", () -> parseBoolean(spec.getSpecial(), false));
    return declared.isEmpty() || offset.isEmpty() || special.isEmpty()
        ? Optional.empty()
        : Optional.of(new TestSpec.BoundaryValues(declared.get(), offset.get(), special.get()));
  }

  private Optional<TestSpec> randomNumbers(TestSpecType spec, DataType type) {
    var count =
        attempt(
            "count",
            () -> whole(required(first(spec.getCount(), spec.getCountElement()), "is missing"), 1));
    var distribution = attempt("distribution", () -> distribution(spec, type));
    var min =
        attempt(
            "min", () -> end(first(spec.getMin(), spec.getMinElement()), distribution, true, type));
    var max =
        attempt(
            "max",
            () -> end(first(spec.getMax(), spec.getMaxElement()), distribution, false, type));
    if (count.isEmpty() || distribution.isEmpty() || min.isEmpty() || max.isEmpty()) {
      return Optional.empty();
    }
    return attempt(
        "min",
        () -> new TestSpec.RandomNumbers(count.get(), min.get(), max.get(), distribution.get()));
  }

  /** The minimum or maximum of random numbers. By default, an operational profile determines it. */
  private static BigDecimal end(
      @Nullable String text, Optional<Distribution> distribution, boolean lower, DataType type) {
    requireNumeric(type);
    if (text == null
        && distribution.isPresent()
        && distribution.get() instanceof Distribution.Weighted weighted) {
      return lower
          ? weighted.ranges().stream()
              .map(WeightedRange::min)
              .min(BigDecimal::compareTo)
              .orElseThrow()
          : weighted.ranges().stream()
              .map(WeightedRange::max)
              .max(BigDecimal::compareTo)
              .orElseThrow();
    }
    return number(required(text, "is missing"), type);
  }

  private Distribution distribution(TestSpecType spec, DataType type) {
    TestSpecType.Distribution element = spec.getDistributionElement();
    List<WeightedRangeType> ranges = new ArrayList<>(spec.getRange());
    StringBuilder text = new StringBuilder();
    String name = spec.getDistribution();
    String mean = first(spec.getMean(), spec.getMeanElement());
    String deviation = first(spec.getStandardDeviation(), spec.getStandardDeviationElement());
    if (element != null) {
      for (Object part : element.getContent()) {
        if (part instanceof JAXBElement<?> e && e.getValue() instanceof WeightedRangeType range) {
          ranges.add(range);
        } else if (part instanceof String characters) {
          text.append(characters);
        }
      }
      name =
          first(name, first(element.getType(), text.toString().isBlank() ? null : text.toString()));
      mean = first(mean, element.getMean());
      deviation = first(deviation, element.getStandardDeviation());
    }
    return switch (name == null ? (ranges.isEmpty() ? "uniform" : "weighted") : name.strip()) {
      case "uniform" -> new Distribution.Uniform();
      case "normal" ->
          new Distribution.Normal(
              Decimals.parse(required(mean, "a normal distribution needs a mean")).doubleValue(),
              Decimals.parse(
                      required(deviation, "a normal distribution needs a standard_deviation"))
                  .doubleValue());
      case "weighted" ->
          new Distribution.Weighted(
              ranges.stream()
                  .map(
                      r ->
                          new WeightedRange(
                              number(required(r.getMin(), "a range needs a min"), type),
                              number(required(r.getMax(), "a range needs a max"), type),
                              Decimals.parse(required(r.getWeight(), "a range needs a weight"))
                                  .doubleValue()))
                  .toList());
      default ->
          throw new IllegalArgumentException(
              "distribution must be uniform, normal or weighted, not '" + name + "'");
    };
  }

  private Optional<TestSpec> randomStrings(TestSpecType spec, DataType type) {
    if (type instanceof DataType.Scalar scalar
        && scalar.type() != ScalarType.STRING
        && scalar.type() != ScalarType.CHAR) {
      problems.error(
          line,
          where,
          "RANDOM_STRING generates strings, but the real_type is " + scalar.typeName());
    }
    var min =
        attempt("min_length", () -> length(first(spec.getMinLength(), spec.getMinLengthElement())));
    var max =
        attempt("max_length", () -> length(first(spec.getMaxLength(), spec.getMaxLengthElement())));
    var alphabet =
        attempt(
            "alphabet",
            () -> parseBoolean(first(spec.getAlphabet(), spec.getAlphabetElement()), false));
    var digits =
        attempt(
            "number", () -> parseBoolean(first(spec.getNumber(), spec.getNumberElement()), false));
    var special =
        attempt(
            "special_char",
            () -> parseBoolean(first(spec.getSpecialChar(), spec.getSpecialCharElement()), false));
    var space =
        attempt("space", () -> parseBoolean(first(spec.getSpace(), spec.getSpaceElement()), false));
    String negative = first(spec.getNegativeCharList(), spec.getNegativeCharListElement(), "");
    if (min.isEmpty()
        || max.isEmpty()
        || alphabet.isEmpty()
        || digits.isEmpty()
        || special.isEmpty()
        || space.isEmpty()) {
      return Optional.empty();
    }
    return attempt(
        "min_length",
        () ->
            new TestSpec.RandomStrings(
                min.get(),
                max.get(),
                alphabet.get(),
                digits.get(),
                special.get(),
                space.get(),
                negative));
  }

  private static int length(@Nullable String text) {
    return whole(required(text, "is missing"), 0);
  }

  private EquivalenceClass equivalenceClass(TestSpecType spec, DataType type) {
    if (spec.getEquivClass().size() != 1) {
      throw new IllegalArgumentException(
          "needs exactly one equiv_class, not " + spec.getEquivClass().size());
    }
    EquivClassType given = spec.getEquivClass().get(0);
    String kind = String.valueOf(given.getType()).replace("_BOUDARY", "_BOUNDARY");
    if (!kind.equals("NEC_BOOLEAN")) {
      requireNumeric(type);
    }
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

  private EquivalenceClass oneBoundary(EquivClassType given, DataType type) {
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

  private static void requireNumeric(DataType type) {
    if (type instanceof DataType.Scalar scalar
        && !scalar.type().isNumeric()
        && scalar.type() != ScalarType.BOOLEAN) {
      throw new IllegalArgumentException(
          "generates numbers, but the real_type is " + scalar.typeName());
    }
  }

  private static BigDecimal number(String text, DataType type) {
    BigDecimal number = Decimals.parse(text);
    boolean whole = type instanceof DataType.Scalar scalar && scalar.type().isInteger();
    if (whole && number.stripTrailingZeros().scale() > 0) {
      throw new IllegalArgumentException(
          text + " is not a whole number, but the real_type is " + type.typeName());
    }
    return number;
  }

  private static BigDecimal positive(String text, DataType type) {
    BigDecimal number = number(text, type);
    if (number.signum() <= 0) {
      throw new IllegalArgumentException("must be greater than 0, not " + text);
    }
    return number;
  }

  private static int whole(String text, int least) {
    try {
      int number = Decimals.parse(text).intValueExact();
      if (number >= least && number <= MAX_COUNT) {
        return number;
      }
    } catch (ArithmeticException e) {
      // Reported below.
    }
    throw new IllegalArgumentException(
        "must be a whole number from " + least + " to " + MAX_COUNT + ", not '" + text + "'");
  }

  private static boolean parseBoolean(@Nullable String text, boolean otherwise) {
    if (text == null || text.isEmpty()) {
      return otherwise;
    }
    return switch (text) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new IllegalArgumentException("must be true or false, not '" + text + "'");
    };
  }

  private <T> Optional<T> attempt(String entry, Supplier<T> reading) {
    return problems.attempt(line, where + "/" + entry, reading);
  }

  private static String required(@Nullable String text, String message) {
    if (text == null) {
      throw new IllegalArgumentException(message);
    }
    return text;
  }

  private static @Nullable String first(@Nullable String one, @Nullable String other) {
    return one != null ? one : other;
  }

  private static String first(@Nullable String one, @Nullable String other, String otherwise) {
    String found = first(one, other);
    return found == null ? otherwise : found;
  }
}
