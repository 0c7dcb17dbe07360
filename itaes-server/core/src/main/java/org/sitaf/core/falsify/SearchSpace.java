package org.sitaf.core.falsify;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/**
 * The ranges of the numeric TDI and TDSD of a model that have a specification: from the smallest to
 * the largest valid value. A point has one coordinate per range, from 0 to 1.
 */
public final class SearchSpace {
  private static final Set<InputKind> SEARCHED = Set.of(InputKind.TDI, InputKind.TDSD);

  private final List<Range> ranges;

  private record Range(int input, double min, double max, ScalarType type) {}

  private SearchSpace(List<Range> ranges) {
    this.ranges = List.copyOf(ranges);
  }

  /** The search space of a model; without dimensions if no input has a range. */
  public static SearchSpace of(TestModel model, long seed) {
    List<Range> ranges = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      if (!SEARCHED.contains(input.kind())
          || !(input.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric())
          || input.specs().stream().noneMatch(SearchSpace::hasRange)) {
        continue;
      }
      double[] numbers =
          TestDataGenerator.generate(input, seed).values().stream()
              .filter(TestValue::valid)
              .mapToDouble(value -> number(value.value()))
              .filter(Double::isFinite)
              .toArray();
      double min = java.util.Arrays.stream(numbers).min().orElse(0);
      double max = java.util.Arrays.stream(numbers).max().orElse(0);
      if (min < max) {
        ranges.add(new Range(i, min, max, scalar.type()));
      }
    }
    return new SearchSpace(ranges);
  }

  private static boolean hasRange(TestSpec spec) {
    return spec instanceof TestSpec.BoundaryValues
        || spec instanceof TestSpec.EquivalencePartitioning
        || spec instanceof TestSpec.RandomNumbers;
  }

  private static double number(Value value) {
    if (value instanceof Value.Whole whole) {
      return whole.number().doubleValue();
    }
    return value instanceof Value.Real real ? real.number() : Double.NaN;
  }

  /** The number of ranges. */
  public int dimensions() {
    return ranges.size();
  }

  /** The coordinates of a case, limited to the ranges. */
  double[] point(List<Value> row) {
    double[] point = new double[ranges.size()];
    for (int d = 0; d < point.length; d++) {
      Range range = ranges.get(d);
      double share = (number(row.get(range.input)) - range.min) / (range.max - range.min);
      point[d] = Double.isNaN(share) ? 0.5 : Math.min(1, Math.max(0, share));
    }
    return point;
  }

  /** A case with the values at a point; the other inputs have the values of another case. */
  List<Value> row(List<Value> others, double[] point) {
    List<Value> row = new ArrayList<>(others);
    for (int d = 0; d < point.length; d++) {
      Range range = ranges.get(d);
      double number = range.min * (1 - point[d]) + range.max * point[d];
      row.set(range.input, value(Math.min(range.max, Math.max(range.min, number)), range.type));
    }
    return row;
  }

  private static Value value(double number, ScalarType type) {
    if (type.isInteger()) {
      return new Value.Whole(
          new BigDecimal(number).setScale(0, RoundingMode.HALF_EVEN).toBigIntegerExact());
    }
    return new Value.Real(
        type == ScalarType.FLOAT ? Double.parseDouble(Float.toString((float) number)) : number);
  }
}
