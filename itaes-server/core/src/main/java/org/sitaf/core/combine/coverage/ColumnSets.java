package org.sitaf.core.combine.coverage;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.Interaction;

/**
 * The sets of columns whose tuples must be covered. A subset of another required set is implied and
 * omitted.
 */
public final class ColumnSets {
  private final Symbols symbols;
  private final List<Interaction> interactions;

  /**
   * Creates the sets of interactions. Columns with a single value are ignored: their tuples are
   * covered whenever the tuples of the other columns are covered.
   */
  public ColumnSets(Symbols symbols, List<Interaction> interactions) {
    this.symbols = symbols;
    this.interactions = new ArrayList<>();
    for (Interaction interaction : interactions) {
      int[] varied =
          Arrays.stream(interaction.parameters()).filter(c -> symbols.levels(c) > 1).toArray();
      if (varied.length > 0) {
        int strength = Math.min(interaction.strength(), varied.length);
        this.interactions.add(new Interaction(strength, varied));
      }
    }
  }

  /** The number of tuples. Tuples of several interactions are counted several times. */
  public BigInteger tuples() {
    BigInteger sum = BigInteger.ZERO;
    for (Interaction interaction : interactions) {
      // Coefficient of x^t in the product of (1 + levels x).
      BigInteger[] coefficients = new BigInteger[interaction.strength() + 1];
      Arrays.fill(coefficients, BigInteger.ZERO);
      coefficients[0] = BigInteger.ONE;
      for (int c : interaction.parameters()) {
        BigInteger levels = BigInteger.valueOf(symbols.levels(c));
        for (int t = coefficients.length - 1; t > 0; t--) {
          coefficients[t] = coefficients[t].add(coefficients[t - 1].multiply(levels));
        }
      }
      sum = sum.add(coefficients[interaction.strength()]);
    }
    return sum;
  }

  /** An upper bound of the size of {@link #list}. */
  public BigInteger count() {
    BigInteger sum = BigInteger.ZERO;
    for (Interaction interaction : interactions) {
      BigInteger chosen = BigInteger.ONE;
      for (int i = 0; i < interaction.strength(); i++) {
        chosen =
            chosen
                .multiply(BigInteger.valueOf(interaction.parameters().length - i))
                .divide(BigInteger.valueOf(i + 1));
      }
      sum = sum.add(chosen);
    }
    return sum;
  }

  /** Whether all combinations of all columns are required. */
  public boolean isProduct() {
    int varied = 0;
    for (int c = 0; c < symbols.columns(); c++) {
      varied += symbols.levels(c) > 1 ? 1 : 0;
    }
    for (Interaction interaction : interactions) {
      if (interaction.strength() == varied) {
        return true;
      }
    }
    return varied == 0;
  }

  /** All sets, each in ascending order. */
  public List<int[]> list() {
    List<int[]> all = new ArrayList<>();
    for (int i = 0; i < interactions.size(); i++) {
      int[] parameters = interactions.get(i).parameters();
      choose(i, parameters, new int[interactions.get(i).strength()], 0, 0, all);
    }
    return all;
  }

  private void choose(int i, int[] from, int[] chosen, int depth, int next, List<int[]> out) {
    if (depth == chosen.length) {
      if (!impliedElsewhere(i, chosen)) {
        out.add(chosen.clone());
      }
      return;
    }
    for (int n = next; n <= from.length - (chosen.length - depth); n++) {
      chosen[depth] = from[n];
      choose(i, from, chosen, depth + 1, n + 1, out);
    }
  }

  private boolean impliedElsewhere(int own, int[] set) {
    for (int j = 0; j < interactions.size() && interactions.size() > 1; j++) {
      Interaction other = interactions.get(j);
      boolean stronger =
          other.strength() > set.length || (other.strength() == set.length && j < own);
      if (j != own && stronger && contains(other.parameters(), set)) {
        return true;
      }
    }
    return false;
  }

  private static boolean contains(int[] sorted, int[] members) {
    for (int member : members) {
      if (Arrays.binarySearch(sorted, member) < 0) {
        return false;
      }
    }
    return true;
  }

  /** Creates a coverage of column sets. */
  public static Coverage coverage(Symbols symbols, List<int[]> sets) {
    List<int[]> pairs = new ArrayList<>();
    List<int[]> triples = new ArrayList<>();
    List<int[]> others = new ArrayList<>();
    for (int[] set : sets) {
      (set.length == 2 ? pairs : set.length == 3 ? triples : others).add(set);
    }
    if (!symbols.hasSets()) {
      others.addAll(pairs);
      pairs.clear();
    }
    if (!triples.isEmpty() && !(worthCube(symbols, triples) && TripleCoverage.fits(symbols))) {
      others.addAll(triples);
      triples.clear();
    }
    List<Coverage> parts = new ArrayList<>();
    if (!pairs.isEmpty()) {
      parts.add(new PairCoverage(symbols, pairs));
    }
    if (!triples.isEmpty()) {
      parts.add(new TripleCoverage(symbols, triples));
    }
    if (!others.isEmpty() || parts.isEmpty()) {
      parts.add(new GeneralCoverage(symbols, others));
    }
    return parts.size() == 1 ? parts.get(0) : new JointCoverage(parts);
  }

  /** For few triples among many columns, {@link GeneralCoverage} is cheaper. */
  private static boolean worthCube(Symbols symbols, List<int[]> triples) {
    return triples.size() > symbols.columns() * symbols.columns() / 4;
  }
}
