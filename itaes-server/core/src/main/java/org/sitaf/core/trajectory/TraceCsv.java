package org.sitaf.core.trajectory;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Writes the signals of a case as CSV: the time in the column {@code t}, then one per signal in the
 * order of their names, in which {@code ranges[2]} precedes {@code ranges[10]}.
 */
public final class TraceCsv {
  private TraceCsv() {}

  /** The same trace gives the same text. */
  public static String write(Trace trace) {
    List<Integer> order =
        IntStream.range(0, trace.names().size())
            .boxed()
            .filter(i -> !trace.names().get(i).equals(CompiledCondition.TIME))
            .sorted(Comparator.comparing(trace.names()::get, TraceCsv::compare))
            .toList();
    StringBuilder text = new StringBuilder(CompiledCondition.TIME);
    order.forEach(i -> text.append(',').append(trace.names().get(i)));
    text.append('\n');
    for (int k = 0; k < trace.count(); k++) {
      text.append(BigDecimal.valueOf(trace.nanos(k), 9).stripTrailingZeros().toPlainString());
      for (int i : order) {
        text.append(',').append(number(trace.columns().get(i)[k]));
      }
      text.append('\n');
    }
    return text.toString();
  }

  /** Compares names by their characters, and the numbers in them by their values. */
  private static int compare(String one, String other) {
    int i = 0;
    int j = 0;
    while (i < one.length() && j < other.length()) {
      int endOfOne = digits(one, i);
      int endOfOther = digits(other, j);
      int order =
          endOfOne > i && endOfOther > j
              ? new BigInteger(one.substring(i, endOfOne))
                  .compareTo(new BigInteger(other.substring(j, endOfOther)))
              : Character.compare(one.charAt(i), other.charAt(j));
      if (order != 0) {
        return order;
      }
      i = Math.max(endOfOne, i + 1);
      j = Math.max(endOfOther, j + 1);
    }
    int rest = Integer.compare(one.length() - i, other.length() - j);
    return rest == 0 ? one.compareTo(other) : rest;
  }

  /** The end of the digits that begin at a position. */
  private static int digits(String name, int from) {
    int end = from;
    while (end < name.length() && name.charAt(end) >= '0' && name.charAt(end) <= '9') {
      end++;
    }
    return end;
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
