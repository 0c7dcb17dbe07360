package org.sitaf.core.score;

import java.math.BigDecimal;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;
import org.sitaf.core.verdict.Literals;

/**
 * Values of an input at which a component may behave differently: the boundaries of its range, and
 * their neighbours. They do not depend on how many of them the suite uses.
 */
final class ProbeValues {
  private static final int MAX_OF_SUITE = 5;
  private static final BigDecimal TWO = BigDecimal.valueOf(2);
  private static final BigDecimal TENTH = new BigDecimal("0.1");

  private final InputElement input;
  private final @Nullable WorldDescription world;

  private ProbeValues(InputElement input, @Nullable WorldDescription world) {
    this.input = input;
    this.world = world;
  }

  /**
   * The values of an input, as literals.
   *
   * @param used the values of the input in the suite
   */
  static List<String> of(InputElement input, @Nullable WorldDescription world, Set<String> used) {
    return List.copyOf(new ProbeValues(input, world).all(used));
  }

  private Set<String> all(Set<String> used) {
    Set<String> literals = new LinkedHashSet<>();
    boolean related = input.specs().stream().anyMatch(TestSpec.Related.class::isInstance);
    if (input.kind() == InputKind.TDTS || related) {
      used.stream().limit(MAX_OF_SUITE).forEach(literals::add);
    } else if (input.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric()) {
      numbers(scalar.type(), used).forEach(number -> add(literal(number, scalar.type()), literals));
    } else if (input.type() instanceof DataType.Scalar scalar
        && scalar.type() == ScalarType.BOOLEAN) {
      literals.addAll(List.of("false", "true"));
    } else if (input.type() instanceof DataType.Enumeration enumeration) {
      literals.addAll(enumeration.literals());
    } else {
      used.stream().limit(MAX_OF_SUITE).forEach(literals::add);
    }
    return literals;
  }

  /** Boundaries of the range, values next to them, and the middle. */
  private Set<BigDecimal> numbers(ScalarType type, Set<String> used) {
    TreeSet<BigDecimal> bounds = new TreeSet<>();
    BigDecimal offset = null;
    for (TestSpec spec : input.specs()) {
      EquivalenceClass values = null;
      if (spec instanceof TestSpec.BoundaryValues boundary) {
        values = boundary.equivalenceClass();
        offset = boundary.offset();
      } else if (spec instanceof TestSpec.EquivalencePartitioning partitions) {
        values = partitions.equivalenceClass();
      } else if (spec instanceof TestSpec.RandomNumbers random) {
        bounds.add(random.min());
        bounds.add(random.max());
      }
      if (values instanceof EquivalenceClass.TwoBoundary two) {
        bounds.add(two.min());
        bounds.add(two.max());
      } else if (values instanceof EquivalenceClass.OneBoundary one) {
        bounds.add(one.boundary());
      } else if (values instanceof EquivalenceClass.NumericSet set) {
        bounds.addAll(set.members());
      } else if (values instanceof EquivalenceClass.Constant constant) {
        bounds.add(constant.value());
      }
    }
    boolean listed = bounds.isEmpty();
    if (listed) {
      used.stream().filter(Literals::isNumber).map(BigDecimal::new).forEach(bounds::add);
    }
    Set<BigDecimal> numbers = new LinkedHashSet<>();
    if (bounds.isEmpty()) {
      return numbers;
    }
    BigDecimal min = bounds.first();
    BigDecimal max = bounds.last();
    BigDecimal step = offset == null ? step(type, min, max) : offset;
    for (BigDecimal bound : List.of(min, max)) {
      numbers.add(bound);
      numbers.add(bound.subtract(step));
      numbers.add(bound.add(step));
    }
    numbers.add(min.add(max).divide(TWO));
    if (listed) {
      // Nothing says which values are valid, so the usual suspects are tried.
      numbers.addAll(List.of(BigDecimal.ZERO, BigDecimal.ONE, BigDecimal.ONE.negate()));
      numbers.add(max.multiply(TWO));
      numbers.add(max.negate());
    }
    return numbers;
  }

  private static BigDecimal step(ScalarType type, BigDecimal min, BigDecimal max) {
    BigDecimal range = max.subtract(min);
    return type.isInteger() || range.signum() == 0 ? BigDecimal.ONE : range.multiply(TENTH);
  }

  private static String literal(BigDecimal number, ScalarType type) {
    return type.isInteger()
        ? number.toBigInteger().toString()
        : Double.toString(number.doubleValue());
  }

  private void add(String literal, Set<String> literals) {
    try {
      Value value = input.value(literal);
      WorldParameter parameter =
          input.kind() != InputKind.TDSD || world == null
              ? null
              : world.parameter(input.name()).orElse(null);
      if (parameter == null || parameter.contains(Literals.real(literal))) {
        literals.add(value.literal());
      }
    } catch (IllegalArgumentException e) {
      // The type cannot hold it.
    }
  }
}
