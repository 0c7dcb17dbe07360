package org.sitaf.core.value;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/**
 * Values that often break robot code: NaN, infinities, signed zero, neighbors of the boundaries,
 * limits of the type, right angles.
 */
final class SpecialValues {
  private SpecialValues() {}

  /** The special values that a specification asks for. */
  static List<Value> of(DataType type, TestSpec spec) {
    if (spec.special() == TestSpec.Special.NONE) {
      return List.of();
    }
    if (spec instanceof TestSpec.BoundaryValues bva) {
      return of(type, bva.equivalenceClass());
    }
    return of(
        type, spec instanceof TestSpec.EquivalencePartitioning ecp ? ecp.equivalenceClass() : null);
  }

  private static List<Value> of(DataType type, @Nullable EquivalenceClass declared) {
    if (!(type instanceof DataType.Scalar scalar)) {
      return List.of();
    }
    ScalarType kind = scalar.type();
    if (kind.isInteger()) {
      return List.of(
          new Value.Whole(java.util.Objects.requireNonNull(kind.minimum())),
          new Value.Whole(java.util.Objects.requireNonNull(kind.maximum())));
    }
    if (!kind.isFloating()) {
      return List.of();
    }
    List<Double> numbers = new ArrayList<>();
    for (double bound : bounds(declared)) {
      numbers.add(kind == ScalarType.FLOAT ? Math.nextDown((float) bound) : Math.nextDown(bound));
      numbers.add(kind == ScalarType.FLOAT ? Math.nextUp((float) bound) : Math.nextUp(bound));
    }
    numbers.addAll(
        List.of(
            Double.NEGATIVE_INFINITY,
            -Math.PI,
            -Math.PI / 2,
            -0.0,
            kind == ScalarType.FLOAT ? (double) Float.MIN_VALUE : Double.MIN_VALUE,
            Math.PI / 2,
            Math.PI,
            Double.POSITIVE_INFINITY,
            Double.NaN));
    return numbers.stream().map(n -> (Value) new Value.Real(n)).toList();
  }

  private static double[] bounds(@Nullable EquivalenceClass declared) {
    if (declared instanceof EquivalenceClass.OneBoundary one) {
      return new double[] {one.boundary().doubleValue()};
    }
    return declared instanceof EquivalenceClass.TwoBoundary two
        ? new double[] {two.min().doubleValue(), two.max().doubleValue()}
        : new double[0];
  }
}
