package org.sitaf.core.combine.feasible;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.WideConstraintException;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;

/**
 * A constraint prepared for fast evaluation, with a table of the allowed tuples if it is small
 * enough.
 */
final class Rule {
  /** Maximum number of tuples in a table. */
  static final long MAX_TABLE = Constraint.MAX_TABLE;

  /** Maximum number of evaluations of a constraint without a table. */
  private static final int MAX_ASKED = 3_000_000;

  /** Maximum number of learned forbidden tuples of a constraint without a table. */
  private static final int MAX_LEARNED = 20_000;

  /** Maximum number of tuples for which the results of a constraint without a table are cached. */
  private static final BigInteger MAX_ANSWERS = BigInteger.valueOf(16_000_000);

  final int[] columns;
  private final Constraint constraint;
  private final int[] strides;
  private final @Nullable BitSet allowed;
  private final int[] levels;
  private final BigInteger combinations;
  private final BitSet answered = new BitSet();
  private final BitSet answers = new BitSet();
  private int asked;
  private int learned;

  Rule(Symbols symbols, Constraint constraint) {
    this.constraint = constraint;
    this.columns = constraint.parameters();
    this.strides = new int[columns.length];
    this.levels = Arrays.stream(columns).map(symbols::levels).toArray();
    this.combinations =
        Arrays.stream(levels)
            .mapToObj(BigInteger::valueOf)
            .reduce(BigInteger.ONE, BigInteger::multiply);
    long product = 1;
    for (int i = columns.length - 1; i >= 0 && product <= MAX_TABLE; i--) {
      strides[i] = (int) product;
      product *= symbols.levels(columns[i]);
    }
    this.allowed = product <= MAX_TABLE ? tabulate(symbols, (int) product) : null;
  }

  private BitSet tabulate(Symbols symbols, int size) {
    BitSet table = new BitSet(size);
    for (int index = 0; index < size; index++) {
      table.set(index, constraint.allowed().test(tuple(symbols, index)));
    }
    return table;
  }

  private int[] tuple(Symbols symbols, int index) {
    int[] values = new int[columns.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = index / strides[i] % symbols.levels(columns[i]);
    }
    return values;
  }

  /** Whether there is a table, so all forbidden tuples are known. */
  boolean tabulated() {
    return allowed != null;
  }

  /** Whether a row satisfies this rule. A row with free cells in these columns does. */
  boolean isSatisfied(Row row) {
    return isSatisfied(row, -1, 0);
  }

  /** Whether a row would satisfy this rule with another value in a column. */
  boolean isSatisfied(Row row, int column, int value) {
    if (allowed == null) {
      int[] values = new int[columns.length];
      for (int i = 0; i < columns.length; i++) {
        values[i] = columns[i] == column ? value : row.value(columns[i]);
        if (values[i] < 0) {
          return true;
        }
      }
      return ask(values);
    }
    int index = 0;
    for (int i = 0; i < columns.length; i++) {
      int v = columns[i] == column ? value : row.value(columns[i]);
      if (v < 0) {
        return true;
      }
      index += v * strides[i];
    }
    return allowed.get(index);
  }

  /**
   * Evaluates a constraint without a table. Results are cached if there are not too many tuples.
   */
  private boolean ask(int[] values) {
    if (combinations.compareTo(MAX_ANSWERS) > 0) {
      return first(values);
    }
    int index = 0;
    for (int i = 0; i < values.length; i++) {
      index = index * levels[i] + values[i];
    }
    if (!answered.get(index)) {
      answers.set(index, first(values));
      answered.set(index);
    }
    return answers.get(index);
  }

  private boolean first(int[] values) {
    if (++asked > MAX_ASKED) {
      throw new WideConstraintException(
          constraint,
          combinations,
          String.format(Locale.ROOT, "%,d were evaluated, which is the limit", MAX_ASKED));
    }
    return constraint.allowed().test(values);
  }

  /**
   * Counts a learned forbidden tuple.
   *
   * @throws WideConstraintException if the limit is exceeded
   */
  void learn() {
    if (++learned > MAX_LEARNED) {
      throw new WideConstraintException(
          constraint,
          combinations,
          String.format(Locale.ROOT, "more than %,d are forbidden individually", MAX_LEARNED));
    }
  }

  /**
   * The forbidden tuples as sets of symbols. Tuples that differ only in the last columns are merged
   * if all values are forbidden.
   */
  List<int[]> forbidden(Symbols symbols) {
    List<int[]> out = new ArrayList<>();
    if (allowed != null) {
      forbidden(symbols, 0, 0, new int[columns.length], 0, out);
    }
    return out;
  }

  private boolean forbidden(
      Symbols symbols, int depth, int index, int[] chosen, int size, List<int[]> out) {
    if (depth == columns.length) {
      if (allowed == null || allowed.get(index)) {
        return false;
      }
      out.add(Arrays.copyOf(chosen, size));
      return true;
    }
    int levels = symbols.levels(columns[depth]);
    if (allForbidden(index, depth, symbols)) {
      out.add(Arrays.copyOf(chosen, size));
      return true;
    }
    for (int v = 0; v < levels; v++) {
      chosen[size] = symbols.symbol(columns[depth], v);
      forbidden(symbols, depth + 1, index + v * strides[depth], chosen, size + 1, out);
    }
    return false;
  }

  /** Whether every completion of the columns from {@code depth} on is forbidden. */
  private boolean allForbidden(int index, int depth, Symbols symbols) {
    int run = strides[depth] * symbols.levels(columns[depth]);
    int next = allowed == null ? index : allowed.nextSetBit(index);
    return next < 0 || next >= index + run;
  }
}
