package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;

/**
 * Finds relations between parameters that explain failures which many tuples would: equality, order
 * and sums of two parameters. Every executed row that fulfils a relation fails.
 */
final class RelationSearch {
  /** With fewer different pairs of values, tuples explain the failures. */
  private static final int MIN_PAIRS = 3;

  private static final int CONFIRMATIONS = 5;
  private static final int MAX_REFUTED = 8;
  private static final int MAX_PARAMETERS = 30;
  private static final int MAX_ROWS = 5_000;

  private final History history;
  private final List<List<Double>> numbers;
  private final List<List<String>> literals;
  private final List<String> names;
  private final java.util.Random random;
  private final Set<String> rejected;

  /**
   * A relation.
   *
   * @param text such as {@code A == B}
   * @param parameters the indices of its parameters
   */
  record Relation(String text, List<Integer> parameters, Predicate<int[]> holds) {}

  /** A confirmed relation with the executions that it needed. */
  record Confirmed(Relation relation, int executions) {}

  /**
   * A search.
   *
   * @param numbers value of each level of each parameter; NaN if it is not a number
   * @param rejected texts of relations that are not searched
   */
  RelationSearch(
      History history,
      List<String> names,
      List<List<Double>> numbers,
      List<List<String>> literals,
      Set<String> rejected,
      long seed) {
    this.history = history;
    this.names = names;
    this.numbers = numbers;
    this.literals = literals;
    this.rejected = Set.copyOf(rejected);
    this.random = new java.util.Random(seed);
  }

  /** Searches and confirms a relation that explains rows without another explanation. */
  Optional<Confirmed> search() throws InterruptedException {
    int began = history.executions();
    if (names.size() > MAX_PARAMETERS || history.failing().size() > MAX_ROWS) {
      return Optional.empty();
    }
    for (int refuted = 0; refuted < MAX_REFUTED && !history.isExhausted(); refuted++) {
      Relation best = best();
      if (best == null) {
        return Optional.empty();
      }
      if (confirm(best)) {
        return Optional.of(new Confirmed(best, history.executions() - began));
      }
    }
    return Optional.empty();
  }

  /**
   * Whether further rows that fulfil the relation fail. Most of them are passing rows in which only
   * the parameters of the relation are changed: rows that keep more of a failing one may hold its
   * true cause.
   */
  private boolean confirm(Relation relation) throws InterruptedException {
    int confirmed = 0;
    for (int attempt = 0; attempt < 400 && confirmed < CONFIRMATIONS; attempt++) {
      int[] row = attempt < 200 ? changedPassing(relation) : changedFailing(relation);
      if (relation.holds().test(row)
          && !history.wasExecuted(row)
          && history.combinations().invalidOf(row) == 0
          && !history.isExhausted()
          && history.combinations().allowed().test(row)) {
        if (!history.execute(row).failed()) {
          return false;
        }
        confirmed++;
      }
    }
    // With no further rows, those of the suite are executed again.
    for (Combinations.Row failed : List.copyOf(history.failing())) {
      if (confirmed < CONFIRMATIONS
          && !history.isExhausted()
          && relation.holds().test(failed.values())) {
        if (!history.execute(failed.values()).failed()) {
          return false;
        }
        confirmed++;
      }
    }
    return confirmed >= CONFIRMATIONS;
  }

  /** A passing row with the values of a failing one in the parameters of the relation. */
  private int[] changedPassing(Relation relation) {
    List<int[]> passing = history.passingValid();
    if (passing.isEmpty()) {
      return changedFailing(relation);
    }
    int[] failing = failing(relation);
    int[] row = passing.get(random.nextInt(passing.size())).clone();
    for (int parameter : relation.parameters()) {
      row[parameter] = failing[parameter];
    }
    return row;
  }

  private int[] changedFailing(Relation relation) {
    int[] row = failing(relation).clone();
    int[] levels = history.combinations().levels();
    for (int i = 0; i < row.length; i++) {
      if (random.nextInt(3) > 0) {
        row[i] = random.nextInt(levels[i]);
      }
    }
    return row;
  }

  /** One of the failing rows that fulfil the relation. */
  private int[] failing(Relation relation) {
    List<int[]> failing =
        history.failing().stream().map(Combinations.Row::values).filter(relation.holds()).toList();
    return failing.get(random.nextInt(failing.size()));
  }

  /** The relation that explains most; of several, the first. */
  private @Nullable Relation best() {
    List<int[]> open =
        history.failing().stream()
            .map(Combinations.Row::values)
            .filter(f -> !history.isExplained(f) && !hasSingleCause(f))
            .toList();
    if (open.size() < MIN_PAIRS) {
      return null;
    }
    Relation best = null;
    long most = 0;
    for (int a = 0; a < names.size(); a++) {
      for (int b = a + 1; b < names.size(); b++) {
        Interruption.check();
        for (Relation relation : relations(a, b, open)) {
          long explained = explained(relation, a, b, open);
          if (explained > most) {
            best = relation;
            most = explained;
          }
        }
      }
    }
    return best;
  }

  /** The rows that a relation explains; 0 if it is not one, or tuples explain them as well. */
  private long explained(Relation relation, int a, int b, List<int[]> open) {
    if (rejected.contains(relation.text()) || isRefuted(relation)) {
      return 0;
    }
    Set<List<Integer>> pairs = new HashSet<>();
    long count = 0;
    for (int[] row : open) {
      if (relation.holds().test(row)) {
        pairs.add(List.of(row[a], row[b]));
        count++;
      }
    }
    return pairs.size() >= MIN_PAIRS ? count : 0;
  }

  /** Whether a case that fulfils the relation passed, unless another input is invalid in it. */
  private boolean isRefuted(Relation relation) {
    long mask = relation.parameters().stream().mapToLong(p -> 1L << p).sum();
    return history.passing().stream()
        .anyMatch(
            p -> relation.holds().test(p) && (history.combinations().invalidOf(p) & ~mask) == 0);
  }

  /** Whether one value of the row alone occurs in failing rows only, and in several. */
  private boolean hasSingleCause(int[] row) {
    for (int i = 0; i < row.length; i++) {
      int at = i;
      if (history.combinations().levels()[i] > 1
          && !history.isRefuted(Tuple.of(row, 1L << at))
          && history.failing().stream().filter(f -> f.values()[at] == row[at]).count() > 1) {
        return true;
      }
    }
    return false;
  }

  private List<Relation> relations(int a, int b, List<int[]> open) {
    String names = this.names.get(a) + " %s " + this.names.get(b);
    List<Integer> both = List.of(a, b);
    List<Relation> relations = new ArrayList<>();
    relations.add(
        new Relation(
            names.formatted("=="),
            both,
            r ->
                literals.get(a).get(r[a]).equals(literals.get(b).get(r[b]))
                    || number(a, r) == number(b, r)));
    if (!areNumbers(a) || !areNumbers(b)) {
      return relations;
    }
    relations.add(new Relation(names.formatted("<"), both, r -> number(a, r) < number(b, r)));
    relations.add(new Relation(names.formatted(">"), both, r -> number(a, r) > number(b, r)));
    relations.add(new Relation(names.formatted("<="), both, r -> number(a, r) <= number(b, r)));
    relations.add(new Relation(names.formatted(">="), both, r -> number(a, r) >= number(b, r)));
    relations.add(new Relation(names.formatted("!="), both, r -> number(a, r) != number(b, r)));
    addSums(a, b, names.formatted("+"), 1, open, relations);
    addSums(a, b, names.formatted("-"), -1, open, relations);
    return relations;
  }

  /** Sums and differences compared with a constant or, for sums, with a third parameter. */
  private void addSums(
      int a, int b, String text, int sign, List<int[]> open, List<Relation> relations) {
    List<Integer> both = List.of(a, b);
    Predicate<int[]> finite = r -> Double.isFinite(number(a, r) + sign * number(b, r));
    double highestPassing = Double.NEGATIVE_INFINITY;
    double lowestPassing = Double.POSITIVE_INFINITY;
    Set<Double> passing = new HashSet<>();
    for (int[] row : history.passingValid()) {
      if (finite.test(row)) {
        double sum = number(a, row) + sign * number(b, row);
        highestPassing = Math.max(highestPassing, sum);
        lowestPassing = Math.min(lowestPassing, sum);
        passing.add(sum);
      }
    }
    double above = Double.POSITIVE_INFINITY;
    double below = Double.NEGATIVE_INFINITY;
    Set<Double> equal = new HashSet<>();
    for (int[] row : open) {
      if (finite.test(row)) {
        double sum = number(a, row) + sign * number(b, row);
        if (sum > highestPassing) {
          above = Math.min(above, sum);
        }
        if (sum < lowestPassing) {
          below = Math.max(below, sum);
        }
        if (!passing.contains(sum)) {
          equal.add(sum);
        }
      }
    }
    for (double sum : equal.stream().sorted().limit(20).toList()) {
      relations.add(
          new Relation(
              text + " == " + constant(sum), both, r -> number(a, r) + sign * number(b, r) == sum));
    }
    if (above < Double.POSITIVE_INFINITY) {
      double least = above;
      relations.add(
          new Relation(
              text + " >= " + constant(least),
              both,
              r -> number(a, r) + sign * number(b, r) >= least));
    }
    if (below > Double.NEGATIVE_INFINITY) {
      double largest = below;
      relations.add(
          new Relation(
              text + " <= " + constant(largest),
              both,
              r -> number(a, r) + sign * number(b, r) <= largest));
    }
    for (int c = 0; sign > 0 && c < names.size(); c++) {
      if (c != a && c != b && areNumbers(c)) {
        int third = c;
        String name = names.get(c);
        List<Integer> all = List.of(a, b, c);
        relations.add(
            new Relation(text + " == " + name, all, r -> sum(a, b, r) == number(third, r)));
        relations.add(new Relation(text + " > " + name, all, r -> sum(a, b, r) > number(third, r)));
        relations.add(new Relation(text + " < " + name, all, r -> sum(a, b, r) < number(third, r)));
      }
    }
  }

  private double sum(int a, int b, int[] row) {
    return number(a, row) + number(b, row);
  }

  private static String constant(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }

  private double number(int parameter, int[] row) {
    return numbers.get(parameter).get(row[parameter]);
  }

  private boolean areNumbers(int parameter) {
    return numbers.get(parameter).size() > 1
        && numbers.get(parameter).stream().noneMatch(n -> n.isNaN());
  }
}
