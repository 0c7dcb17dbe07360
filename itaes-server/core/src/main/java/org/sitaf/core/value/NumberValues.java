package org.sitaf.core.value;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/** Generates numbers for ECP, BVA and RANDOM. Arithmetic is decimal, so 0.1 + 0.2 is 0.3. */
final class NumberValues {
  /** Ascending numbers, false before true, then NaN, then values that are not numbers. */
  static final Comparator<Value> ASCENDING =
      Comparator.<Value, Boolean>comparing(Value.Text.class::isInstance)
          .thenComparing(
              (one, other) ->
                  one instanceof Value.Whole a && other instanceof Value.Whole b
                      ? a.number().compareTo(b.number())
                      : Double.compare(asDouble(one), asDouble(other)));

  private static final BigDecimal TWO = BigDecimal.valueOf(2);

  /** Maximum distance of a representative of an open class from its boundary, in offsets. */
  private static final BigDecimal OPEN_SPAN = BigDecimal.valueOf(100);

  /** Maximum draws for one new value, before the range is considered exhausted. */
  private static final int DRAWS = 1000;

  /** Maximum draws for all values of a range. */
  private static final long MAX_DRAWS = 4_000_000;

  private final DataType type;
  private final ElementRandom random;
  private final List<String> unrepresentable = new ArrayList<>();

  NumberValues(DataType type, ElementRandom random) {
    this.type = type;
    this.random = random;
  }

  /** Literals of generated numbers that the type cannot represent. */
  List<String> unrepresentable() {
    return unrepresentable;
  }

  List<Value> generate(TestSpec spec) {
    Set<BigDecimal> numbers = new LinkedHashSet<>();
    if (spec instanceof TestSpec.BoundaryValues bva && bva.equivalenceClass() != null) {
      numbers.addAll(boundaries(bva.equivalenceClass(), bva.offset()));
    } else if (spec instanceof TestSpec.EquivalencePartitioning ecp) {
      numbers.addAll(representatives(ecp));
    } else if (spec instanceof TestSpec.RandomNumbers draw) {
      numbers.addAll(draw(draw));
    }
    List<Value> values = new ArrayList<>();
    for (BigDecimal number : numbers) {
      try {
        values.add(
            isBoolean()
                ? new Value.Bool(number.signum() != 0)
                : Value.parse(number.toPlainString(), type));
      } catch (IllegalArgumentException e) {
        unrepresentable.add(number.toPlainString());
      }
    }
    return values;
  }

  /** Fig. 6: values around each boundary, and the middle of a closed class. */
  private List<BigDecimal> boundaries(EquivalenceClass declared, BigDecimal offset) {
    if (declared instanceof EquivalenceClass.OneBoundary one) {
      BigDecimal b = one.boundary();
      return List.of(b.subtract(offset), b, b.add(offset));
    }
    EquivalenceClass.TwoBoundary two = (EquivalenceClass.TwoBoundary) declared;
    return List.of(
        two.min().subtract(offset),
        two.min(),
        two.min().add(offset),
        middle(two.min(), two.max()),
        two.max().subtract(offset),
        two.max(),
        two.max().add(offset));
  }

  private List<BigDecimal> representatives(TestSpec.EquivalencePartitioning ecp) {
    EquivalenceClass declared = ecp.equivalenceClass();
    BigDecimal offset = ecp.offset();
    int count = ecp.representatives();
    List<BigDecimal> all = new ArrayList<>();
    if (declared instanceof EquivalenceClass.TwoBoundary two) {
      all.addAll(open(two.min(), offset.negate(), count));
      all.addAll(closed(two, count));
      all.addAll(open(two.max(), offset, count));
    } else if (declared instanceof EquivalenceClass.OneBoundary one) {
      all.addAll(open(one.boundary(), offset.negate(), count));
      all.addAll(open(one.boundary(), offset, count));
    } else if (declared instanceof EquivalenceClass.BooleanClass) {
      all.add(BigDecimal.ZERO);
      all.add(BigDecimal.ONE);
    } else if (declared instanceof EquivalenceClass.Constant constant) {
      all.add(constant.value());
      all.addAll(open(constant.value(), offset, count));
    } else if (declared instanceof EquivalenceClass.NumericSet set) {
      all.addAll(members(set, count));
      all.addAll(
          open(set.members().stream().max(BigDecimal::compareTo).orElseThrow(), offset, count));
    }
    return all;
  }

  /** Representatives of an open class: first the boundary plus offset, then random numbers. */
  private List<BigDecimal> open(BigDecimal boundary, BigDecimal offset, int count) {
    BigDecimal nearest = boundary.add(offset);
    BigDecimal farthest = boundary.add(offset.multiply(OPEN_SPAN));
    return further(nearest, nearest.min(farthest), nearest.max(farthest), count);
  }

  private List<BigDecimal> closed(EquivalenceClass.TwoBoundary two, int count) {
    List<BigDecimal> inside = further(middle(two.min(), two.max()), two.min(), two.max(), count);
    return inside.stream().filter(two::contains).toList();
  }

  private List<BigDecimal> members(EquivalenceClass.NumericSet set, int count) {
    List<BigDecimal> rest = new ArrayList<>(set.members().stream().distinct().sorted().toList());
    List<BigDecimal> chosen = new ArrayList<>();
    chosen.add(rest.remove((rest.size() - 1) / 2));
    while (chosen.size() < count && !rest.isEmpty()) {
      chosen.add(rest.remove(random.nextInt(rest.size())));
    }
    return chosen;
  }

  private List<BigDecimal> further(BigDecimal first, BigDecimal min, BigDecimal max, int count) {
    Set<BigDecimal> all = new LinkedHashSet<>();
    all.add(first.stripTrailingZeros());
    long most = Math.min((long) DRAWS * count, MAX_DRAWS);
    for (int draws = 0; all.size() < count && draws < most; draws++) {
      Interruption.check();
      all.add(uniform(min, max).stripTrailingZeros());
    }
    return List.copyOf(all);
  }

  private Set<BigDecimal> draw(TestSpec.RandomNumbers draw) {
    Set<BigDecimal> all = new LinkedHashSet<>();
    long most = Math.min(DRAWS + draw.count() * 10L, MAX_DRAWS);
    for (int draws = 0; all.size() < draw.count() && draws < most; draws++) {
      Interruption.check();
      BigDecimal number = one(draw).stripTrailingZeros();
      if (number.compareTo(draw.min()) >= 0 && number.compareTo(draw.max()) <= 0) {
        all.add(number);
      }
    }
    return all;
  }

  private BigDecimal one(TestSpec.RandomNumbers draw) {
    if (draw.distribution() instanceof TestSpec.Distribution.Normal normal) {
      double number = normal.mean() + normal.standardDeviation() * random.nextNormal();
      BigDecimal decimal = real(number);
      return isWhole() ? decimal.setScale(0, RoundingMode.HALF_EVEN) : decimal;
    }
    if (draw.distribution() instanceof TestSpec.Distribution.Weighted weighted) {
      double total = weighted.ranges().stream().mapToDouble(TestSpec.WeightedRange::weight).sum();
      double at = random.nextDouble() * total;
      TestSpec.WeightedRange chosen = weighted.ranges().get(weighted.ranges().size() - 1);
      for (TestSpec.WeightedRange range : weighted.ranges()) {
        at -= range.weight();
        if (at < 0) {
          chosen = range;
          break;
        }
      }
      return uniform(chosen.min(), chosen.max());
    }
    return uniform(draw.min(), draw.max());
  }

  private BigDecimal uniform(BigDecimal min, BigDecimal max) {
    if (isWhole()) {
      return new BigDecimal(
          random.nextInteger(
              min.setScale(0, RoundingMode.CEILING).toBigInteger(),
              max.setScale(0, RoundingMode.FLOOR).toBigInteger()));
    }
    return real(random.nextReal(min, max));
  }

  /** The shortest decimal of the nearest number that the type can represent. */
  private BigDecimal real(double number) {
    boolean single = type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.FLOAT;
    return new BigDecimal(
        single && Math.abs(number) <= Float.MAX_VALUE
            ? Float.toString((float) number)
            : Double.toString(number));
  }

  private BigDecimal middle(BigDecimal min, BigDecimal max) {
    BigDecimal middle = min.add(max).divide(TWO);
    return isWhole() ? middle.setScale(0, RoundingMode.FLOOR) : middle;
  }

  private boolean isWhole() {
    return type instanceof DataType.Scalar scalar && scalar.type().isInteger();
  }

  private boolean isBoolean() {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.BOOLEAN;
  }

  static double asDouble(Value value) {
    if (value instanceof Value.Whole whole) {
      return whole.number().doubleValue();
    }
    if (value instanceof Value.Real real) {
      return real.number();
    }
    return value instanceof Value.Bool bool && bool.value() ? 1 : 0;
  }
}
