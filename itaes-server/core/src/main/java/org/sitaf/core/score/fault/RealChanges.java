package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.sitaf.core.verdict.Literals;

/** Faults of floating-point numbers: units, signs, offsets, scales, precision, lost values. */
final class RealChanges {
  private static final double FEET_PER_METRE = 1 / 0.3048;
  private static final double KMH_PER_METRE_PER_SECOND = 3.6;
  private static final double MILLI = 1e-3;
  private static final double CENTI = 1e-2;

  private final boolean single;
  private final List<ValueChange> changes = new ArrayList<>();

  private RealChanges(boolean single) {
    this.single = single;
  }

  /**
   * All faults.
   *
   * @param single whether the numbers have single precision
   */
  static List<ValueChange> all(boolean single) {
    RealChanges all = new RealChanges(single);
    all.units();
    all.arithmetic();
    all.precision();
    all.constants();
    return all.changes;
  }

  /** A few faults of different kinds, for values that consist of many numbers. */
  static List<ValueChange> few(boolean single) {
    RealChanges few = new RealChanges(single);
    few.add("sign inverted", x -> -x);
    few.add("radians taken for degrees", Math::toRadians);
    few.add("metres taken for millimetres", x -> x * MILLI);
    few.add("1 too large", x -> x + 1);
    few.add("10 % too large", x -> x * 1.1);
    few.constant("always 0", 0);
    few.constant("NaN instead of the value", Double.NaN);
    return few.changes;
  }

  private void units() {
    add("radians taken for degrees", Math::toRadians);
    add("degrees taken for radians", Math::toDegrees);
    add("metres taken for millimetres", x -> x * MILLI);
    add("millimetres taken for metres", x -> x / MILLI);
    add("metres taken for feet", x -> x / FEET_PER_METRE);
    add("m/s taken for km/h", x -> x / KMH_PER_METRE_PER_SECOND);
  }

  private void arithmetic() {
    add("sign inverted", x -> -x);
    add("sign lost", Math::abs);
    add("half", x -> x / 2);
    add("double", x -> x * 2);
    for (double offset : new double[] {1, MILLI}) {
      add(offset + " too large", x -> x + offset);
      add(offset + " too small", x -> x - offset);
    }
    for (double percent : new double[] {10, 1}) {
      add(percent + " % too large", x -> x * (1 + percent * CENTI));
      add(percent + " % too small", x -> x * (1 - percent * CENTI));
    }
    add("wrapped to -pi..pi", x -> Math.IEEEremainder(x, 2 * Math.PI));
    add("saturated at -1 and 1", x -> Math.max(-1, Math.min(1, x)));
  }

  private void precision() {
    add(
        "one unit in the last place too large",
        single ? x -> Math.nextUp((float) x) : Math::nextUp);
    if (!single) {
      add("single precision", x -> (float) x);
    }
    add("fraction cut off", x -> x < 0 ? Math.ceil(x) : Math.floor(x));
    add("rounded to a whole number", Math::rint);
  }

  private void constants() {
    constant("always 0", 0);
    constant("always 1", 1);
    constant("NaN instead of the value", Double.NaN);
    constant("infinity instead of the value", Double.POSITIVE_INFINITY);
    constant(
        "the largest number instead of the value", single ? Float.MAX_VALUE : Double.MAX_VALUE);
  }

  private void add(String text, DoubleUnaryOperator change) {
    changes.add(
        new ValueChange(
            text,
            literal ->
                Literals.isReal(literal)
                    ? literal(literal, change.applyAsDouble(Literals.real(literal)))
                    : literal));
  }

  private void constant(String text, double value) {
    add(text, x -> value);
  }

  /** Keeps the literal of an equal number, which may be written in another way. */
  private String literal(String before, double number) {
    double held = single ? (float) number : number;
    double known = Literals.real(before);
    boolean same = known == held || Double.isNaN(known) && Double.isNaN(held);
    return same ? before : written(held);
  }

  private String written(double number) {
    return single ? Float.toString((float) number) : Double.toString(number);
  }
}
