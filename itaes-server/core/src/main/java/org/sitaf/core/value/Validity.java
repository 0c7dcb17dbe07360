package org.sitaf.core.value;

import java.math.BigDecimal;
import java.util.List;
import org.sitaf.core.model.EquivalenceClass;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/** Decides whether a value is valid by the specifications of its element. */
final class Validity {
  private final List<TestSpec> specs;

  Validity(List<TestSpec> specs) {
    this.specs = specs;
  }

  /**
   * Whether no class excludes a number, and any RANDOM_STRING could generate a text. NaN and
   * infinities are invalid if there is a class.
   */
  boolean allows(Value value) {
    List<TestSpec.RandomStrings> strings =
        specs.stream()
            .filter(TestSpec.RandomStrings.class::isInstance)
            .map(TestSpec.RandomStrings.class::cast)
            .toList();
    if (!strings.isEmpty()) {
      return strings.stream().anyMatch(spec -> StringValues.isValid(value.literal(), spec));
    }
    return specs.stream().allMatch(spec -> allows(value, spec));
  }

  private static boolean allows(Value value, TestSpec spec) {
    if (spec instanceof TestSpec.BoundaryValues bva) {
      return isFinite(value)
          && (bva.equivalenceClass() == null || contains(bva.equivalenceClass(), value));
    }
    return !(spec instanceof TestSpec.EquivalencePartitioning ecp)
        || (isFinite(value) && contains(ecp.equivalenceClass(), value));
  }

  private static boolean isFinite(Value value) {
    double number = NumberValues.asDouble(value);
    return !Double.isNaN(number) && (value instanceof Value.Whole || !Double.isInfinite(number));
  }

  private static boolean contains(EquivalenceClass declared, Value value) {
    return declared.contains(
        value instanceof Value.Whole whole
            ? new BigDecimal(whole.number())
            : new BigDecimal(Double.toString(NumberValues.asDouble(value))));
  }
}
