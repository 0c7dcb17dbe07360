package org.sitaf.core.value;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/**
 * Test Data Generator (TDG, paper section 3.1.2): generates the values of a test element from its
 * specification.
 */
public final class TestDataGenerator {
  private TestDataGenerator() {}

  /**
   * Generates the values of an element.
   *
   * @param seed seed of random values; the same seed gives the same values
   * @return values without duplicates, numbers in ascending order, marked as valid or invalid
   */
  public static TestData generate(InputElement element, long seed) {
    Collected collected = new Collected();
    ElementRandom random = new ElementRandom(seed, element.name());
    TestSpec spec = element.spec();
    if (spec instanceof TestSpec.RandomStrings strings) {
      StringValues.generate(strings, random).forEach(collected::add);
    } else if (spec != null) {
      NumberValues numbers = new NumberValues(element.type(), random);
      numbers.generate(spec).forEach(collected::add);
      collected.unrepresentable.addAll(numbers.unrepresentable());
    } else if (element.type() instanceof DataType.Enumeration enumeration
        && element.userValues().isEmpty()) {
      enumeration
          .literals()
          .forEach(literal -> collected.add(new TestValue(new Value.Text(literal), true)));
    } else if (isBoolean(element.type()) && element.userValues().isEmpty()) {
      collected.add(new TestValue(new Value.Bool(false), true));
      collected.add(new TestValue(new Value.Bool(true), true));
    }
    for (Value value : element.userValues()) {
      // Errors and delays of a test stub are always valid: the specification covers only values.
      boolean special = element.kind() == InputKind.TDTS && Value.isErrorOrDelay(value.literal());
      collected.add(new TestValue(value, spec == null || special || isValid(value, spec)));
    }
    List<TestValue> values = new ArrayList<>(collected.byLiteral.values());
    if (isNumber(element.type())) {
      values.sort(Comparator.comparing(TestValue::value, NumberValues.ASCENDING));
    }
    return new TestData(values, collected.unrepresentable);
  }

  private static boolean isValid(Value value, TestSpec spec) {
    return spec instanceof TestSpec.RandomStrings strings
        ? StringValues.isValid(value.literal(), strings)
        : NumberValues.isValid(value, spec);
  }

  private static boolean isNumber(DataType type) {
    return isBoolean(type) || (type instanceof DataType.Scalar scalar && scalar.type().isNumeric());
  }

  private static boolean isBoolean(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.BOOLEAN;
  }

  /** Removes duplicates. The first of several equal values is kept. */
  private static final class Collected {
    private final Map<String, TestValue> byLiteral = new LinkedHashMap<>();
    private final List<String> unrepresentable = new ArrayList<>();

    void add(TestValue value) {
      byLiteral.putIfAbsent(value.value().literal(), value);
    }
  }
}
