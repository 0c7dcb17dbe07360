package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Settings.first;
import static org.sitaf.core.model.document.Settings.number;
import static org.sitaf.core.model.document.Settings.parseBoolean;
import static org.sitaf.core.model.document.Settings.positive;
import static org.sitaf.core.model.document.Settings.requireNumeric;
import static org.sitaf.core.model.document.Settings.required;
import static org.sitaf.core.model.document.Settings.whole;

import jakarta.xml.bind.JAXBElement;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.Decimals;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.RelatedOffset;
import org.sitaf.core.model.RotationForm;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.TestSpec.Distribution;
import org.sitaf.core.model.TestSpec.WeightedRange;
import org.sitaf.schemas.TestSpecType;
import org.sitaf.schemas.WeightedRangeType;

/**
 * Reads one {@code test_spec}. Problems are reported with the name of the element and of the entry.
 */
final class TestSpecReader {
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
    SettingsInUse.check(spec).forEach(message -> problems.error(line, where, message));
    return switch (String.valueOf(spec.getType())) {
      case "ECP" -> partitioning(spec, type);
      case "BVA" -> boundaries(spec, type);
      case "RANDOM" -> randomNumbers(spec, type);
      case "RANDOM_STRING" -> randomStrings(spec, type);
      case "ROTATION" -> rotations(spec, type);
      case "DIRECTION" -> directions(spec, type);
      case "POSE" -> poses(spec, type);
      case "RELATED" -> related(spec);
      default -> {
        problems.error(
            line,
            where,
            "type must be ECP, BVA, RANDOM, RANDOM_STRING, ROTATION, DIRECTION, POSE or RELATED,"
                + " not '"
                + spec.getType()
                + "'");
        yield Optional.empty();
      }
    };
  }

  private Optional<TestSpec> partitioning(TestSpecType spec, DataType type) {
    var declared = attempt("equiv_class", () -> EquivalenceClassReader.read(spec, type));
    var representatives =
        attempt(
            "representatives",
            () ->
                whole(first(spec.getRepresentatives(), spec.getRepresentativesElement(), "1"), 1));
    var offset =
        attempt(
            "offset", () -> positive(first(spec.getOffset(), spec.getOffsetElement(), "1"), type));
    var special = special(spec);
    if (declared.isPresent() && declared.get() instanceof EquivalenceClass.BooleanClass) {
      refuse("offset", first(spec.getOffset(), spec.getOffsetElement()), "NEC_BOOLEAN");
      refuse(
          "representatives",
          first(spec.getRepresentatives(), spec.getRepresentativesElement()),
          "NEC_BOOLEAN");
    }
    return declared.isEmpty() || representatives.isEmpty() || offset.isEmpty() || special.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new TestSpec.EquivalencePartitioning(
                declared.get(), representatives.get(), offset.get(), special.get()));
  }

  private Optional<TestSpec> boundaries(TestSpecType spec, DataType type) {
    var special = special(spec);
    boolean onlySpecial =
        spec.getEquivClass().isEmpty() && spec.getSpecial() != null && !spec.getSpecial().isEmpty();
    if (onlySpecial) {
      refuse(
          "offset",
          first(spec.getOffset(), spec.getOffsetElement()),
          "BVA without an equiv_class, which has no boundaries");
      attempt(
          "special",
          () -> {
            requireNumeric(type);
            return true;
          });
    }
    Optional<EquivalenceClass> declared =
        onlySpecial
            ? Optional.empty()
            : attempt(
                "equiv_class",
                () -> {
                  EquivalenceClass given = EquivalenceClassReader.read(spec, type);
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
            () -> {
              String given = first(spec.getOffset(), spec.getOffsetElement());
              return positive(
                  given == null && onlySpecial
                      ? "1"
                      : required(given, "is missing; BVA needs an offset greater than 0"),
                  type);
            });
    if ((declared.isEmpty() && !onlySpecial) || offset.isEmpty() || special.isEmpty()) {
      return Optional.empty();
    }
    return attempt(
        "special",
        () -> new TestSpec.BoundaryValues(declared.orElse(null), offset.get(), special.get()));
  }

  /** Reports a setting that is given but has no effect. */
  private void refuse(String setting, @Nullable String given, String in) {
    if (given != null) {
      problems.error(line, where + "/" + setting, "has no effect in " + in + "; remove it");
    }
  }

  private Optional<TestSpec.Special> special(TestSpecType spec) {
    return attempt(
        "special",
        () ->
            switch (spec.getSpecial() == null ? "" : spec.getSpecial()) {
              case "", "false", "0" -> TestSpec.Special.NONE;
              case "true", "1" -> TestSpec.Special.COMBINED;
              case "each" -> TestSpec.Special.EACH;
              default ->
                  throw new IllegalArgumentException(
                      "must be true, false or each, not '" + spec.getSpecial() + "'");
            });
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
    var special = special(spec);
    if (count.isEmpty()
        || distribution.isEmpty()
        || min.isEmpty()
        || max.isEmpty()
        || special.isEmpty()) {
      return Optional.empty();
    }
    return attempt(
        "min",
        () ->
            new TestSpec.RandomNumbers(
                count.get(), min.get(), max.get(), distribution.get(), special.get()));
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

  private Optional<TestSpec> rotations(TestSpecType spec, DataType type) {
    requireWhole(spec, type);
    var form = form(spec);
    var count = count(spec, "48");
    return form.isEmpty() || count.isEmpty()
        ? Optional.empty()
        : Optional.of(new TestSpec.Rotations(form.get().orElse(null), count.get()));
  }

  private Optional<TestSpec> directions(TestSpecType spec, DataType type) {
    requireWhole(spec, type);
    var count = count(spec, "26");
    var length = real("length", spec.getLength(), "1");
    return count.isEmpty() || length.isEmpty()
        ? Optional.empty()
        : attempt("length", () -> new TestSpec.Directions(count.get(), length.get()));
  }

  private Optional<TestSpec> poses(TestSpecType spec, DataType type) {
    requireWhole(spec, type);
    var form = form(spec);
    var count = count(spec, "48");
    var min = real("min", first(spec.getMin(), spec.getMinElement()), "-1");
    var max = real("max", first(spec.getMax(), spec.getMaxElement()), "1");
    return form.isEmpty() || count.isEmpty() || min.isEmpty() || max.isEmpty()
        ? Optional.empty()
        : attempt(
            "min",
            () -> new TestSpec.Poses(form.get().orElse(null), count.get(), min.get(), max.get()));
  }

  private Optional<TestSpec> related(TestSpecType spec) {
    var to =
        attempt("to", () -> required(spec.getTo(), "is missing; name the other input").strip());
    var offsets =
        attempt(
            "offsets",
            () ->
                Arrays.stream(
                        required(spec.getOffsets(), "is missing; write for example \"0 1ulp -10%\"")
                            .strip()
                            .split("[\\s,]+"))
                    .filter(text -> !text.isEmpty())
                    .map(RelatedOffset::parse)
                    .toList());
    return to.isEmpty() || offsets.isEmpty()
        ? Optional.empty()
        : attempt("offsets", () -> new TestSpec.Related(to.get(), offsets.get()));
  }

  private void requireWhole(TestSpecType spec, DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      problems.error(
          line,
          where,
          spec.getType()
              + " generates whole values; the element needs abstract_type STRUCT or SEQUENCE, but"
              + " the real_type is "
              + scalar.typeName());
    }
  }

  private Optional<Optional<RotationForm>> form(TestSpecType spec) {
    return attempt(
        "as", () -> Optional.ofNullable(spec.getAs()).map(String::strip).map(RotationForm::parse));
  }

  private Optional<Integer> count(TestSpecType spec, String otherwise) {
    return attempt(
        "count", () -> whole(first(spec.getCount(), spec.getCountElement(), otherwise), 1));
  }

  private Optional<Double> real(String entry, @Nullable String text, String otherwise) {
    return attempt(
        entry, () -> Decimals.parse(text == null ? otherwise : text.strip()).doubleValue());
  }

  private <T> Optional<T> attempt(String entry, Supplier<T> reading) {
    return problems.attempt(line, where + "/" + entry, reading);
  }
}
