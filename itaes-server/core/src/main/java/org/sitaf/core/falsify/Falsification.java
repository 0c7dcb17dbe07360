package org.sitaf.core.falsify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hipparchus.exception.MathIllegalStateException;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.CMAESOptimizer;
import org.hipparchus.random.Well19937c;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.model.Value;

/**
 * Searches for the case with the smallest margin: first the given cases, then where an estimate of
 * the margin is low or uncertain (Bayesian optimisation), and, when that makes no progress, with
 * CMA-ES from the best case that is far from what was searched. Ends when a case violates the
 * condition, or when the budget is used.
 */
public final class Falsification {
  /** Replaces infinite margins and those of cases that cannot be executed. */
  private static final double WORST = 1e9;

  /** Initial standard deviation as a share of each range. */
  private static final double SIGMA = 0.25;

  private static final int MAX_ITERATIONS = 10_000;

  /** Generations without progress after which the search continues elsewhere. */
  private static final int PATIENCE = 3;

  /** The smallest relative decrease that counts as progress. */
  private static final double PROGRESS = 0.05;

  /** Batches of proposals without progress after which the optimiser searches from a case. */
  private static final int MAX_STALE = 3;

  /** Distance of starts as a share of the ranges (root mean square). */
  private static final double FAR = 0.25;

  /** Cases in a batch of uniformly distributed values. */
  private static final int UNIFORM_BATCH = 50;

  /** Runs without a new case after which the ranges are considered exhausted. */
  private static final int MAX_FRUITLESS = 20;

  private final SearchSpace space;
  private final int budget;
  private final long seed;
  private final Executor executor;
  private final Map<List<String>, Outcome> known = new HashMap<>();
  private final Proposals proposals;
  private int executions;
  private Found best = new Found(List.of(), new Outcome(Double.POSITIVE_INFINITY, false, ""), 0);
  private @Nullable Found firstViolation;

  /** Executes cases. */
  @FunctionalInterface
  public interface Executor {
    /**
     * Executes a batch.
     *
     * @return one outcome per case
     * @throws InterruptedException if the search is cancelled
     */
    List<Outcome> execute(List<List<Value>> rows) throws InterruptedException;
  }

  /**
   * What happened in a case.
   *
   * @param margin smallest margin of the searched conditions
   * @param violated whether one of them is false
   * @param condition the one with the smallest margin; empty if none was evaluated
   */
  public record Outcome(double margin, boolean violated, String condition) {
    /** A case that was not executed, for example because a pre-condition excludes it. */
    public static final Outcome NONE = new Outcome(Double.NaN, false, "");
  }

  /**
   * The case with the smallest margin.
   *
   * @param row values of all inputs; empty if no case was executed
   * @param executions executed cases
   */
  public record Found(List<Value> row, Outcome outcome, int executions) {
    public Found {
      row = List.copyOf(row);
    }
  }

  /**
   * Creates a search.
   *
   * @param budget maximum number of executed cases
   */
  public Falsification(SearchSpace space, int budget, long seed, Executor executor) {
    if (space.dimensions() < 1 || budget < 1) {
      throw new IllegalArgumentException("a search needs a range and a budget");
    }
    this.space = space;
    this.budget = budget;
    this.seed = seed;
    this.executor = executor;
    this.proposals = new Proposals(space.dimensions());
  }

  /**
   * Searches.
   *
   * @param first cases to begin with, usually a covering array
   */
  public Found search(List<List<Value>> first) throws InterruptedException {
    execute(first.subList(0, Math.min(first.size(), budget)));
    List<List<Value>> starts = new ArrayList<>(first);
    starts.removeIf(row -> !known.containsKey(key(row)));
    starts.sort(Comparator.comparingDouble(row -> value(known.get(key(row)))));
    Well19937c random = new Well19937c(seed);
    List<double[]> searched = new ArrayList<>();
    int fruitless = 0;
    int stale = 0;
    while (!isOver() && !starts.isEmpty() && fruitless < MAX_FRUITLESS) {
      int before = executions;
      double lowest = value(best.outcome());
      if (stale < MAX_STALE) {
        execute(proposed(starts, random));
        boolean progress = value(best.outcome()) < lowest - PROGRESS * Math.abs(lowest);
        stale = progress ? 0 : stale + 1;
      } else {
        List<Value> start = start(starts, searched, random);
        searched.add(space.point(start));
        searched.add(space.point(climb(start, random.nextLong())));
        stale = 0;
      }
      fruitless = executions == before ? fruitless + 1 : 0;
    }
    return new Found(best.row(), best.outcome(), executions);
  }

  /** Cases where the margin may be low; the inputs without a range are those of some start. */
  private List<List<Value>> proposed(List<List<Value>> starts, Well19937c random)
      throws InterruptedException {
    List<List<Value>> rows = new ArrayList<>();
    for (double[] point : proposals.next(population(), random)) {
      Interruption.check();
      boolean ofBest = !best.row().isEmpty() && random.nextBoolean();
      rows.add(space.row(ofBest ? best.row() : starts.get(random.nextInt(starts.size())), point));
    }
    return rows;
  }

  /**
   * Executes cases with uniformly distributed values until one violates the condition: the rival of
   * {@link #search}. The cases do not depend on each other, so its batches are large; the cases of
   * a batch after the one that violates the condition do not count.
   *
   * @param others give the values of inputs without a range
   */
  public Found searchUniformly(List<List<Value>> others) throws InterruptedException {
    Well19937c random = new Well19937c(seed);
    int fruitless = 0;
    while (!isOver() && !others.isEmpty() && fruitless < MAX_FRUITLESS) {
      int before = executions;
      List<List<Value>> rows = new ArrayList<>();
      for (int i = 0; i < UNIFORM_BATCH; i++) {
        rows.add(anywhere(others, random));
      }
      execute(rows);
      fruitless = executions == before ? fruitless + 1 : 0;
    }
    return firstViolation == null
        ? new Found(best.row(), best.outcome(), executions)
        : firstViolation;
  }

  private List<Value> anywhere(List<List<Value>> others, Well19937c random) {
    double[] point = new double[space.dimensions()];
    Arrays.setAll(point, d -> random.nextDouble());
    return space.row(others.get(random.nextInt(others.size())), point);
  }

  /** The number of cases in a generation, and in a batch. */
  private int population() {
    int dimensions = space.dimensions();
    return 4 + (int) (3 * Math.log(dimensions)) + dimensions % 2;
  }

  /** The best start that is far from what was searched; a random one if there is none. */
  private List<Value> start(List<List<Value>> starts, List<double[]> searched, Well19937c random) {
    for (List<Value> start : starts) {
      double[] point = space.point(start);
      if (searched.stream().allMatch(other -> distance(point, other) > FAR)) {
        return start;
      }
    }
    return anywhere(starts, random);
  }

  private static double distance(double[] one, double[] other) {
    double sum = 0;
    for (int d = 0; d < one.length; d++) {
      sum += (one[d] - other[d]) * (one[d] - other[d]);
    }
    return Math.sqrt(sum / one.length);
  }

  private boolean isOver() {
    return best.outcome().violated() || executions >= budget;
  }

  /**
   * One run of the optimiser. Hipparchus evaluates one point after the other; the points of a
   * generation do not depend on each other. To execute them as a batch, the optimiser is run again
   * from its start with all known values until it asks for a generation that is not known.
   *
   * @return the best case of the run
   */
  private List<Value> climb(List<Value> start, long runSeed) throws InterruptedException {
    List<Double> values = new ArrayList<>();
    List<Value> lowest = start;
    double lowestValue = WORST;
    int sinceProgress = 0;
    while (!isOver() && sinceProgress < PATIENCE) {
      Interruption.check();
      List<double[]> asked = ask(start, runSeed, values);
      if (asked.isEmpty()) {
        return lowest;
      }
      List<List<Value>> rows = asked.stream().map(point -> space.row(start, point)).toList();
      execute(rows);
      sinceProgress++;
      for (List<Value> row : rows) {
        double value = value(known.get(key(row)));
        values.add(value);
        if (value < lowestValue - PROGRESS * Math.abs(lowestValue)) {
          sinceProgress = 0;
        }
        if (value < lowestValue) {
          lowestValue = value;
          lowest = row;
        }
      }
    }
    return lowest;
  }

  /** The points of the next generation; empty if the optimiser has converged. */
  private List<double[]> ask(List<Value> start, long runSeed, List<Double> values) {
    int dimensions = space.dimensions();
    int population = population();
    List<double[]> asked = new ArrayList<>();
    int[] count = {0};
    ObjectiveFunction margin =
        new ObjectiveFunction(
            point -> {
              int index = count[0]++;
              if (index < values.size()) {
                return values.get(index);
              }
              // The first point is the start; generations follow.
              if (!asked.isEmpty() && (index - 1) % population == 0) {
                throw new GenerationComplete();
              }
              asked.add(point.clone());
              return WORST;
            });
    double[] lower = new double[dimensions];
    double[] upper = new double[dimensions];
    double[] sigma = new double[dimensions];
    Arrays.fill(upper, 1);
    Arrays.fill(sigma, SIGMA);
    try {
      new CMAESOptimizer(
              MAX_ITERATIONS, 0, true, 0, 0, new Well19937c(runSeed), false, (i, a, b) -> false)
          .optimize(
              new MaxEval(MAX_ITERATIONS),
              margin,
              GoalType.MINIMIZE,
              new InitialGuess(space.point(start)),
              new SimpleBounds(lower, upper),
              new CMAESOptimizer.Sigma(sigma),
              new CMAESOptimizer.PopulationSize(population));
    } catch (GenerationComplete | MathIllegalStateException e) {
      // The points are collected, or the maximum of evaluations is reached.
    }
    return asked;
  }

  /** Executes the cases that are not known yet, up to the budget. */
  private void execute(List<List<Value>> rows) throws InterruptedException {
    List<List<Value>> fresh = new ArrayList<>();
    for (List<Value> row : rows) {
      if (!known.containsKey(key(row))
          && fresh.stream().noneMatch(other -> key(other).equals(key(row)))
          && fresh.size() < budget - executions) {
        fresh.add(row);
      }
    }
    if (fresh.isEmpty()) {
      return;
    }
    List<Outcome> outcomes = executor.execute(fresh);
    for (int i = 0; i < fresh.size(); i++) {
      Outcome outcome = outcomes.get(i);
      known.put(key(fresh.get(i)), outcome);
      proposals.add(space.point(fresh.get(i)), value(outcome));
      if (outcome == Outcome.NONE) {
        continue;
      }
      executions++;
      if (outcome.violated() && firstViolation == null) {
        firstViolation = new Found(fresh.get(i), outcome, executions);
      }
      if (!outcome.condition().isEmpty() && isWorse(outcome, best.outcome())) {
        best = new Found(fresh.get(i), outcome, executions);
      }
    }
  }

  private static boolean isWorse(Outcome one, Outcome other) {
    return one.violated() != other.violated()
        ? one.violated()
        : value(one) < value(other) || other.condition().isEmpty();
  }

  private static double value(@Nullable Outcome outcome) {
    if (outcome == null || Double.isNaN(outcome.margin())) {
      return WORST;
    }
    return Math.max(-WORST, Math.min(WORST, outcome.margin()));
  }

  private static List<String> key(List<Value> row) {
    return row.stream().map(Value::literal).toList();
  }

  private static final class GenerationComplete extends RuntimeException {
    private static final long serialVersionUID = 1L;

    GenerationComplete() {
      super(null, null, false, false);
    }
  }
}
