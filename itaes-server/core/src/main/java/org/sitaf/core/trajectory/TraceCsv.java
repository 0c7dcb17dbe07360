package org.sitaf.core.trajectory;

import java.math.BigDecimal;

/** Writes the signals of a case as CSV: the time in the column {@code t}, then one per signal. */
public final class TraceCsv {
  private TraceCsv() {}

  /** The same trace gives the same text. */
  public static String write(Trace trace) {
    StringBuilder text = new StringBuilder(CompiledCondition.TIME);
    for (String name : trace.names()) {
      if (!name.equals(CompiledCondition.TIME)) {
        text.append(',').append(name);
      }
    }
    text.append('\n');
    for (int k = 0; k < trace.count(); k++) {
      text.append(BigDecimal.valueOf(trace.nanos(k), 9).stripTrailingZeros().toPlainString());
      for (int i = 0; i < trace.names().size(); i++) {
        if (!trace.names().get(i).equals(CompiledCondition.TIME)) {
          text.append(',').append(number(trace.columns().get(i)[k]));
        }
      }
      text.append('\n');
    }
    return text.toString();
  }

  private static String number(double value) {
    if (Double.isNaN(value) || Double.isInfinite(value)) {
      return Double.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
    }
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
