package org.sitaf.core.combine;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.combine.coverage.ColumnSets;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.search.Product;

/**
 * Test Data Combinator (paper, Fig. 2): generates a small set of rows that contains every required
 * tuple of values. The same problem, effort and seed give the same rows on every machine.
 */
public final class TestDataCombinator {
  /** Maximum number of rows of a full product. */
  public static final long MAX_PRODUCT = 1_000_000;

  /** Maximum number of required tuples. */
  public static final long MAX_TUPLES = 120_000_000;

  /** Maximum number of column sets with required tuples. */
  static final long MAX_SETS = 5_000_000;

  /** Maximum lower bound of the number of rows. */
  static final long MAX_ROWS = 1_000_000;

  /**
   * Solves a combination problem.
   *
   * @param seed seed of random choices
   * @throws TooManyCombinationsException if a full product has more than {@link #MAX_PRODUCT} rows,
   *     or there are more than {@link #MAX_TUPLES} tuples
   * @throws WideConstraintException if a constraint relates too many combinations of values
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public CoveringArray combine(
      CombinationProblem problem, Effort effort, long seed, Progress progress) {
    Symbols symbols = new Symbols(problem.levels());
    ColumnSets sets = new ColumnSets(symbols, problem.interactions());
    boolean product = sets.isProduct();
    checkSize(symbols, sets, product);
    Feasibility feasibility = new Feasibility(symbols, problem.constraints());
    List<Integer> rejected = rejectedSeeds(problem, symbols, feasibility);
    CombinationProblem kept = without(rejected, problem);
    CoveringArray array =
        product
            ? product(kept, symbols, feasibility)
            : new Combination(kept, symbols, sets.list(), feasibility, effort, progress).run(seed);
    return new CoveringArray(array.rows(), array.tuples(), array.optimal(), rejected);
  }

  /**
   * Grows rows that cover as many tuples as fit.
   *
   * @param limit maximum number of rows; more are returned only if more are needed
   * @param eachValue whether each possible value must occur
   * @param preferred values of which every second row holds one, unless it would cover fewer tuples
   * @throws TooManyCombinationsException if there are more than {@link #MAX_TUPLES} tuples
   * @throws WideConstraintException if a constraint relates too many combinations of values
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public GrownArray grow(
      CombinationProblem problem,
      int limit,
      boolean eachValue,
      List<ParameterValue> preferred,
      long seed,
      Progress progress) {
    Symbols symbols = new Symbols(problem.levels());
    ColumnSets sets = new ColumnSets(symbols, problem.interactions());
    checkSize(symbols, sets, false);
    Feasibility feasibility = new Feasibility(symbols, problem.constraints());
    List<Integer> rejected = rejectedSeeds(problem, symbols, feasibility);
    GrownArray grown =
        new Growth(without(rejected, problem), symbols, sets.list(), feasibility, seed)
            .grow(limit, eachValue, preferred, progress);
    return new GrownArray(grown.rows(), grown.needed(), grown.covered(), grown.tuples(), rejected);
  }

  /** The tuples that rows do not cover, by pairs of parameters. */
  public GrownArray.Losses losses(CombinationProblem problem, List<int[]> rows) {
    Symbols symbols = new Symbols(problem.levels());
    List<int[]> sets = new ColumnSets(symbols, problem.interactions()).list();
    Feasibility feasibility = new Feasibility(symbols, problem.constraints());
    return new Growth(problem, symbols, sets, feasibility, 0).losses(rows);
  }

  private static List<Integer> rejectedSeeds(
      CombinationProblem problem, Symbols symbols, Feasibility feasibility) {
    List<int[]> seeds = problem.seeds();
    return IntStream.range(0, seeds.size())
        .filter(i -> !isAllowed(new Row(symbols, seeds.get(i)), feasibility))
        .boxed()
        .toList();
  }

  private static CombinationProblem without(List<Integer> rejected, CombinationProblem problem) {
    List<int[]> seeds = problem.seeds();
    Set<Integer> omitted = new HashSet<>(rejected);
    return problem.withSeeds(
        IntStream.range(0, seeds.size())
            .filter(i -> !omitted.contains(i))
            .mapToObj(seeds::get)
            .toList());
  }

  /**
   * Maximum lower bound of the number of rows, such that the rows use at most a third of the
   * memory.
   */
  static long maxRows(Symbols symbols) {
    long bytes = 200 + 24L * symbols.columns() + (symbols.hasSets() ? 8L * symbols.words() : 0);
    return Math.min(MAX_ROWS, Runtime.getRuntime().maxMemory() / 3 / bytes);
  }

  private static boolean isAllowed(Row row, Feasibility feasibility) {
    return feasibility.rules().allow(row) && feasibility.complete(row) != null;
  }

  private static void checkSize(Symbols symbols, ColumnSets sets, boolean product) {
    if (product) {
      BigInteger rows = BigInteger.ONE;
      for (int levels : symbols.levels()) {
        rows = rows.multiply(BigInteger.valueOf(levels));
      }
      if (rows.compareTo(BigInteger.valueOf(MAX_PRODUCT)) > 0) {
        throw new TooManyCombinationsException("number of all combinations", rows, MAX_PRODUCT);
      }
      return;
    }
    BigInteger tuples = sets.tuples();
    // The counters of all tuples may use at most half of the memory.
    long limit = Math.min(MAX_TUPLES, Runtime.getRuntime().maxMemory() / 9);
    if (tuples.compareTo(BigInteger.valueOf(limit)) > 0) {
      throw new TooManyCombinationsException("number of tuples to cover", tuples, limit);
    }
    BigInteger listed = sets.count();
    if (listed.compareTo(BigInteger.valueOf(MAX_SETS)) > 0) {
      throw new TooManyCombinationsException(
          "number of parameter sets to combine", listed, MAX_SETS);
    }
  }

  private static CoveringArray product(
      CombinationProblem problem, Symbols symbols, Feasibility feasibility) {
    List<Row> kept = new ArrayList<>();
    for (int[] seed : problem.seeds()) {
      Row row = feasibility.complete(new Row(symbols, seed));
      for (int c = 0; c < symbols.columns(); c++) {
        if (row != null && row.value(c) == Row.FREE) {
          row.set(c, 0);
        }
      }
      kept.add(java.util.Objects.requireNonNull(row));
    }
    List<int[]> rows = new Product(symbols, feasibility).rows(kept);
    Set<List<Integer>> distinct = new HashSet<>();
    kept.forEach(row -> distinct.add(Arrays.stream(row.values()).boxed().toList()));
    long covered = (long) rows.size() + distinct.size();
    long whole = 1;
    for (int levels : problem.levels()) {
      whole *= levels;
    }
    List<int[]> all = new ArrayList<>(kept.stream().map(Row::values).toList());
    all.addAll(rows);
    // For a full product, excluded combinations are only counted: they are expected, so no examples
    // are listed.
    return new CoveringArray(
        all.toArray(int[][]::new),
        new TupleReport(covered, whole - covered, List.of()),
        true,
        List.of());
  }
}
