package org.sitaf.core.combine.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.SeededRandom;

/**
 * Coverage of tuples of any strength, with one counter per tuple. Column sets may differ in size.
 */
final class GeneralCoverage implements Coverage {
  private static final int NOT_REQUIRED = 1 << 29;

  private final Symbols symbols;
  private final int[][] sets;
  private final int[][] strides;
  private final int[] bases;
  private final int[] counts;
  private final long[] open;
  private final long[] openWords;

  /**
   * For each column and each set that contains it: length, base, stride of the column, then column
   * and stride of the other columns.
   */
  private final int[][] through;

  private final int cost;
  private final int[] scratch;
  private long required;
  private int uncovered;

  /**
   * Index of the last set with an exclusion. Exclusions are grouped by set, so the next one is
   * near.
   */
  private int lastExcluded;

  GeneralCoverage(Symbols symbols, List<int[]> columnSets) {
    this.symbols = symbols;
    this.sets = columnSets.toArray(int[][]::new);
    this.strides = new int[sets.length][];
    this.bases = new int[sets.length + 1];
    for (int i = 0; i < sets.length; i++) {
      int[] stride = new int[sets[i].length];
      int product = 1;
      for (int j = stride.length - 1; j >= 0; j--) {
        stride[j] = product;
        product = Math.multiplyExact(product, symbols.levels(sets[i][j]));
      }
      strides[i] = stride;
      bases[i + 1] = Math.addExact(bases[i], product);
    }
    this.uncovered = bases[sets.length];
    this.required = uncovered;
    this.counts = new int[uncovered];
    this.open = new long[(uncovered + 63) >>> 6];
    this.openWords = new long[(open.length + 63) >>> 6];
    for (int i = 0; i < uncovered; i++) {
      open[i >>> 6] |= 1L << i;
      openWords[i >>> 12] |= 1L << (i >>> 6);
    }
    this.through = new int[symbols.columns()][];
    int widest = 0;
    for (int c = 0; c < through.length; c++) {
      through[c] = setsThrough(c);
      widest = Math.max(widest, through[c].length);
    }
    int most = Arrays.stream(symbols.levels).max().orElse(1);
    this.scratch = new int[most];
    this.cost = widest + 4;
  }

  private int[] setsThrough(int column) {
    List<int[]> parts = new ArrayList<>();
    int length = 0;
    for (int i = 0; i < sets.length; i++) {
      int at = Arrays.binarySearch(sets[i], column);
      if (at < 0) {
        continue;
      }
      int[] part = new int[3 + 2 * (sets[i].length - 1)];
      part[0] = part.length;
      part[1] = bases[i];
      part[2] = strides[i][at];
      int next = 3;
      for (int j = 0; j < sets[i].length; j++) {
        if (j != at) {
          part[next++] = sets[i][j];
          part[next++] = strides[i][j];
        }
      }
      parts.add(part);
      length += part.length;
    }
    int[] all = new int[length];
    int next = 0;
    for (int[] part : parts) {
      System.arraycopy(part, 0, all, next, part.length);
      next += part.length;
    }
    return all;
  }

  @Override
  public long required() {
    return required;
  }

  @Override
  public int uncovered() {
    return uncovered;
  }

  @Override
  public int gain(Row row, int column, int value) {
    return counted(row, column, value, 0);
  }

  @Override
  public int loss(Row row, int column) {
    return counted(row, column, row.values[column], 1);
  }

  private int counted(Row row, int column, int value, int times) {
    int[] parts = through[column];
    int[] values = row.values;
    int sum = 0;
    int i = 0;
    while (i < parts.length) {
      int end = i + parts[i];
      int index = parts[i + 1] + parts[i + 2] * value;
      i += 3;
      while (i < end) {
        int v = values[parts[i]];
        if (v < 0) {
          index = -1;
          break;
        }
        index += v * parts[i + 1];
        i += 2;
      }
      i = end;
      if (index >= 0 && counts[index] == times) {
        sum++;
      }
    }
    return sum;
  }

  @Override
  public void gains(Row row, int column, int[] out) {
    int levels = symbols.levels(column);
    Arrays.fill(scratch, 0, levels, 0);
    int[] parts = through[column];
    int[] values = row.values;
    int i = 0;
    while (i < parts.length) {
      int end = i + parts[i];
      int index = parts[i + 1];
      int stride = parts[i + 2];
      i += 3;
      while (i < end) {
        int v = values[parts[i]];
        if (v < 0) {
          index = -1;
          break;
        }
        index += v * parts[i + 1];
        i += 2;
      }
      i = end;
      if (index >= 0) {
        for (int v = 0; v < levels; v++, index += stride) {
          scratch[v] += counts[index] == 0 ? 1 : 0;
        }
      }
    }
    System.arraycopy(scratch, 0, out, 0, levels);
  }

  @Override
  public void add(Row row) {
    for (int i = 0; i < sets.length; i++) {
      count(index(i, row.values), 1);
    }
  }

  @Override
  public void remove(Row row) {
    for (int i = 0; i < sets.length; i++) {
      count(index(i, row.values), -1);
    }
  }

  private int index(int set, int[] values) {
    int index = bases[set];
    int[] columns = sets[set];
    for (int j = 0; j < columns.length; j++) {
      index += strides[set][j] * values[columns[j]];
    }
    return index;
  }

  @Override
  public void change(Row row, int column, int value) {
    int[] parts = through[column];
    int before = row.values[column];
    int i = 0;
    while (i < parts.length) {
      int end = i + parts[i];
      int index = parts[i + 1];
      int stride = parts[i + 2];
      for (i += 3; i < end; i += 2) {
        index += row.values[parts[i]] * parts[i + 1];
      }
      count(index + stride * before, -1);
      count(index + stride * value, 1);
    }
    row.set(column, value);
  }

  private void count(int index, int by) {
    int n = counts[index] + by;
    counts[index] = n;
    if (n == 0 && by < 0) {
      uncovered++;
      open[index >>> 6] |= 1L << index;
      openWords[index >>> 12] |= 1L << (index >>> 6);
    } else if (n == 1 && by > 0) {
      close(index);
    }
  }

  private void close(int index) {
    uncovered--;
    open[index >>> 6] &= ~(1L << index);
    if (open[index >>> 6] == 0) {
      openWords[index >>> 12] &= ~(1L << (index >>> 6));
    }
  }

  @Override
  public Tuple pick(SeededRandom random) {
    int at = nextOpen(random.nextInt(counts.length));
    int set = Arrays.binarySearch(bases, at);
    if (set < 0) {
      set = -set - 2;
    }
    int[] values = new int[sets[set].length];
    int rest = at - bases[set];
    for (int j = 0; j < values.length; j++) {
      values[j] = rest / strides[set][j];
      rest %= strides[set][j];
    }
    return new Tuple(sets[set], values);
  }

  /** The first uncovered tuple from an index on, with wrap-around. */
  private int nextOpen(int from) {
    int word = from >>> 6;
    long here = open[word] & (-1L << from);
    while (here == 0) {
      word = word + 1 == open.length ? 0 : word + 1;
      int summary = word >>> 6;
      long words = openWords[summary] & (-1L << word);
      while (words == 0) {
        summary = summary + 1 == openWords.length ? 0 : summary + 1;
        words = openWords[summary];
      }
      word = (summary << 6) + Long.numberOfTrailingZeros(words);
      here = open[word];
    }
    return (word << 6) + Long.numberOfTrailingZeros(here);
  }

  @Override
  public void exclude(int[] columns, int[] values) {
    for (int tried = 0; tried < sets.length; tried++) {
      int i = lastExcluded;
      if (Arrays.equals(sets[i], columns)) {
        int index = index(i, columns, values);
        if (counts[index] == 0) {
          counts[index] = NOT_REQUIRED;
          close(index);
          required--;
        }
        return;
      }
      lastExcluded = lastExcluded + 1 == sets.length ? 0 : lastExcluded + 1;
    }
  }

  private int index(int set, int[] columns, int[] values) {
    int index = bases[set];
    for (int j = 0; j < columns.length; j++) {
      index += strides[set][j] * values[j];
    }
    return index;
  }

  @Override
  public int cost() {
    return cost;
  }

  @Override
  public int changeCost() {
    return 4 * cost;
  }

  @Override
  public int gainsCost(int levels) {
    return cost + cost * levels / 8;
  }
}
