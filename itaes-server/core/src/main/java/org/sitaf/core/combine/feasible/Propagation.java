package org.sitaf.core.combine.feasible;

import java.util.List;
import org.sitaf.core.combine.coverage.Symbols;

/**
 * Unit propagation over forbidden sets of symbols: excludes values that contradict the chosen ones.
 * Sound but not complete: {@link Solver} decides in the end.
 */
public final class Propagation {
  private final Symbols symbols;
  private final int[][] sets;
  private final int[][] setsOf;
  private final boolean[] out;
  private final int[] left;
  private final boolean[] chosen;

  /** The chosen symbol of each column, which excludes the others; -1 if none. */
  private final int[] choice;

  private final int[] trail;
  private int trailSize;
  private int done;

  Propagation(Symbols symbols, List<int[]> forbidden) {
    this.symbols = symbols;
    this.sets = forbidden.toArray(int[][]::new);
    int[] counts = new int[symbols.count()];
    for (int[] set : sets) {
      for (int s : set) {
        counts[s]++;
      }
    }
    this.setsOf = new int[symbols.count()][];
    for (int s = 0; s < counts.length; s++) {
      setsOf[s] = new int[counts[s]];
    }
    for (int i = 0; i < sets.length; i++) {
      for (int s : sets[i]) {
        setsOf[s][--counts[s]] = i;
      }
    }
    this.out = new boolean[symbols.count()];
    this.chosen = new boolean[symbols.count()];
    this.choice = new int[symbols.columns()];
    java.util.Arrays.fill(choice, -1);
    this.left = symbols.levels();
    this.trail = new int[2 * symbols.count() + 2];
  }

  /** Propagates the sets with a single symbol. Returns false if nothing is allowed. */
  boolean start() {
    for (int[] set : sets) {
      if (set.length == 0 || (set.length == 1 && !exclude(set[0]))) {
        return false;
      }
    }
    return conclude();
  }

  /** The current state for {@link #undo}. */
  public int mark() {
    return trailSize;
  }

  /** Restores the state of a mark. */
  public void undo(int mark) {
    while (trailSize > mark) {
      int entry = trail[--trailSize];
      if (entry >= 0) {
        chosen[entry] = false;
        choice[symbols.column(entry)] = -1;
      } else {
        int symbol = -entry - 1;
        out[symbol] = false;
        left[symbols.column(symbol)]++;
      }
    }
    done = trailSize;
  }

  /** Whether a value is not excluded. */
  public boolean open(int column, int value) {
    return !isOut(symbols.symbol(column, value));
  }

  private boolean isOut(int symbol) {
    int other = choice[symbols.column(symbol)];
    return out[symbol] || (other >= 0 && other != symbol);
  }

  /** Chooses a value. Returns false after a contradiction; the caller must then undo the choice. */
  public boolean choose(int column, int value) {
    int symbol = symbols.symbol(column, value);
    if (isOut(symbol)) {
      return false;
    }
    return accept(symbol) && conclude();
  }

  /**
   * Excludes a value. Returns false after a contradiction; the caller must then undo the exclusion.
   */
  public boolean excludeValue(int column, int value) {
    return exclude(symbols.symbol(column, value)) && conclude();
  }

  private boolean accept(int symbol) {
    if (chosen[symbol]) {
      return true;
    }
    chosen[symbol] = true;
    choice[symbols.column(symbol)] = symbol;
    trail[trailSize++] = symbol;
    return true;
  }

  private boolean exclude(int symbol) {
    if (isOut(symbol)) {
      return true;
    }
    int column = symbols.column(symbol);
    if (chosen[symbol] || left[column] == 1) {
      return false;
    }
    out[symbol] = true;
    trail[trailSize++] = -symbol - 1;
    if (--left[column] == 1) {
      for (int s = symbols.first(column); s < symbols.first(column + 1); s++) {
        if (!out[s]) {
          return accept(s);
        }
      }
    }
    return true;
  }

  private boolean conclude() {
    while (done < trailSize) {
      int symbol = trail[done++];
      if (symbol < 0) {
        continue;
      }
      for (int i : setsOf[symbol]) {
        int open = -1;
        int others = 0;
        for (int s : sets[i]) {
          if (!chosen[s]) {
            others += isOut(s) ? 2 : 1;
            open = s;
          }
        }
        if (others == 0 || (others == 1 && !exclude(open))) {
          return false;
        }
      }
    }
    return true;
  }
}
