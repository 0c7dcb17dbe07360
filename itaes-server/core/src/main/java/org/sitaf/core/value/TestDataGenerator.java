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
import org.sitaf.core.value.spatial.SpatialValues;

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
   * @return values without duplicates, numbers in ascending order, then those that follow another
   *     input; marked as valid or invalid
   * @throws IllegalArgumentException if the type cannot hold the values of a specification
   */
  public static TestData generate(InputElement element, long seed) {
    Collected collected = new Collected();
    ElementRandom random = new ElementRandom(seed, element.name());
    NumberValues numbers = new NumberValues(element.type(), random);
    Validity validity = new Validity(element.specs());
    for (TestSpec spec : element.specs()) {
      if (spec instanceof TestSpec.RandomStrings strings) {
        StringValues.generate(strings, random).forEach(collected::add);
      } else if (spec instanceof TestSpec.Rotations rotations) {
        collected.addValid(SpatialValues.rotations(rotations, element.type(), random::nextDouble));
      } else if (spec instanceof TestSpec.Directions directions) {
        collected.addValid(
            SpatialValues.directions(directions, element.type(), random::nextDouble));
      } else if (spec instanceof TestSpec.Poses poses) {
        collected.addValid(SpatialValues.poses(poses, element.type(), random::nextDouble));
      } else if (spec instanceof TestSpec.Related related) {
        related
            .offsets()
            .forEach(
                offset ->
                    collected.add(TestValue.related(new TestValue.Relation(related.to(), offset))));
      } else {
        requireNumbers(element, spec);
        for (Value value : numbers.generate(spec)) {
          collected.add(new TestValue(value, validity.allows(value)));
        }
        for (Value value : SpecialValues.of(element.type(), spec)) {
          collected.add(
              new TestValue(
                  value, validity.allows(value), spec.special() == TestSpec.Special.EACH, null));
        }
      }
    }
    if (element.specs().isEmpty() && element.userValues().isEmpty()) {
      collected.addValid(implied(element.type()));
    }
    for (Value value : element.userValues()) {
      // Errors and delays of a test stub are always valid: the specification covers only values.
      boolean answer = element.kind() == InputKind.TDTS && Value.isErrorOrDelay(value.literal());
      collected.add(new TestValue(value, answer || validity.allows(value)));
    }
    List<TestValue> values = new ArrayList<>(collected.byLiteral.values());
    if (isNumber(element.type())) {
      values.sort(Comparator.comparing(TestValue::value, NumberValues.ASCENDING));
    }
    return new TestData(values, numbers.unrepresentable());
  }

  /**
   * Whether a value that the element does not generate, such as one of a kept case, lies in its
   * classes. Without a class nothing is known about it, and it counts as invalid.
   */
  public static boolean isInClasses(InputElement element, Value value) {
    boolean declared =
        element.specs().stream()
            .anyMatch(
                spec ->
                    spec instanceof TestSpec.BoundaryValues
                        || spec instanceof TestSpec.EquivalencePartitioning);
    return declared && isNumber(element.type()) && new Validity(element.specs()).allows(value);
  }

  /** All values of an enumeration or a boolean. */
  private static List<Value> implied(DataType type) {
    if (type instanceof DataType.Enumeration enumeration) {
      return enumeration.literals().stream().map(l -> (Value) new Value.Text(l)).toList();
    }
    return isBoolean(type) ? List.of(new Value.Bool(false), new Value.Bool(true)) : List.of();
  }

  private static void requireNumbers(InputElement element, TestSpec spec) {
    if (!(element.type() instanceof DataType.Scalar)
        && !(element.type() instanceof DataType.Unknown)) {
      throw new IllegalArgumentException(
          spec.scheme()
              + " generates numbers, but the element is a whole "
              + element.type().typeName()
              + "; name one of its members or cells");
    }
  }

  private static boolean isNumber(DataType type) {
    return isBoolean(type) || (type instanceof DataType.Scalar scalar && scalar.type().isNumeric());
  }

  private static boolean isBoolean(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.BOOLEAN;
  }

  /**
   * Removes duplicates. The first of several equal values is kept; a value that only some
   * specifications list for a single case is combined.
   */
  private static final class Collected {
    private final Map<String, TestValue> byLiteral = new LinkedHashMap<>();

    void addValid(List<Value> values) {
      values.forEach(value -> add(new TestValue(value, true)));
    }

    void add(TestValue value) {
      TestValue known = byLiteral.putIfAbsent(value.value().literal(), value);
      if (known != null && known.each() && !value.each()) {
        byLiteral.put(value.value().literal(), value);
      }
    }
  }
}
