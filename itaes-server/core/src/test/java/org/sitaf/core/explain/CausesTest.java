package org.sitaf.core.explain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TestDataCombinator;

/** A short form of tests/benchmarks/explain. */
class CausesTest {
  private static final int BUDGET = 300;

  private record Planted(int[] levels, Tuple forbidden, List<Tuple> causes, List<int[]> rows) {
    static Planted of(int seed, int count) {
      Random random = new Random(seed);
      while (true) {
        int[] levels = random.ints(6 + random.nextInt(6), 2, 6).toArray();
        Tuple forbidden = tuple(levels, 2, random);
        List<Tuple> causes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
          causes.add(tuple(levels, 1 + random.nextInt(2), random));
        }
        int[] parameters =
            java.util.stream.IntStream.range(0, levels.length)
                .filter(i -> forbidden.values()[i] != Tuple.ANY)
                .toArray();
        int[] values = Arrays.stream(parameters).map(i -> forbidden.values()[i]).toArray();
        List<int[]> rows =
            List.of(
                new TestDataCombinator()
                    .combine(
                        CombinationProblem.tWay(2, levels)
                            .withConstraints(List.of(Constraint.forbid(parameters, values))),
                        Effort.FAST,
                        seed,
                        Progress.NONE)
                    .rows());
        Planted planted = new Planted(levels, forbidden, causes, rows);
        boolean minimal =
            causes.stream()
                .allMatch(
                    c ->
                        causes.stream().noneMatch(o -> o != c && o.isPartOf(c))
                            && (c.mask() & forbidden.mask()) == 0
                            && rows.stream().anyMatch(c::isIn));
        if (minimal) {
          return planted;
        }
      }
    }

    private static Tuple tuple(int[] levels, int size, Random random) {
      int[] values = new int[levels.length];
      Arrays.fill(values, Tuple.ANY);
      while (new Tuple(values).size() < size) {
        int i = random.nextInt(levels.length);
        values[i] = random.nextInt(levels[i]);
      }
      return new Tuple(values);
    }

    Outcome execute(int[] row) {
      assertThat(forbidden.isIn(row)).isFalse();
      return causes.stream().anyMatch(c -> c.isIn(row))
          ? new Outcome(true, "FAIL")
          : Outcome.PASSED;
    }

    Causes find() throws InterruptedException {
      Combinations combinations =
          new Combinations(
              levels,
              rows.stream().map(r -> new Combinations.Row(r, execute(r))).toList(),
              row -> !forbidden.isIn(row),
              2);
      return Causes.find(combinations, this::execute, BUDGET, 1);
    }
  }

  @Test
  void findsPlantedCausesWithFewExecutions() throws InterruptedException {
    int exact = 0;
    int executions = 0;
    for (int i = 0; i < 40; i++) {
      Planted planted = Planted.of(i, 1 + i % 3);
      Causes causes = planted.find();
      Set<Tuple> found =
          causes.found().stream().map(Causes.Found::tuple).collect(Collectors.toSet());
      exact += found.equals(Set.copyOf(planted.causes())) ? 1 : 0;
      executions += causes.executions();
    }
    assertThat(exact).isGreaterThanOrEqualTo(36);
    assertThat(executions / 40.0).isLessThan(12);
  }

  @Test
  void theSameSearchGivesTheSameCauses() throws InterruptedException {
    Planted planted = Planted.of(7, 2);
    assertThat(planted.find()).isEqualTo(planted.find());
  }

  @Test
  void aFailureThatIsNotReproducibleIsNotExplained() throws InterruptedException {
    List<Combinations.Row> rows = new ArrayList<>();
    for (int a = 0; a < 3; a++) {
      for (int b = 0; b < 3; b++) {
        rows.add(
            new Combinations.Row(
                new int[] {a, b}, a == 1 && b == 1 ? new Outcome(true, "FAIL") : Outcome.PASSED));
      }
    }
    Causes causes =
        Causes.find(
            new Combinations(new int[] {3, 3}, rows, row -> true, 2),
            row -> Outcome.PASSED,
            BUDGET,
            1);
    assertThat(causes.found()).isEmpty();
    assertThat(causes.unexplained()).containsExactly(4);
  }

  @Test
  void theBudgetIsAMaximum() throws InterruptedException {
    Planted planted = Planted.of(3, 3);
    Combinations combinations =
        new Combinations(
            planted.levels(),
            planted.rows().stream().map(r -> new Combinations.Row(r, planted.execute(r))).toList(),
            row -> !planted.forbidden().isIn(row),
            2);
    assertThat(Causes.find(combinations, planted::execute, 1, 1).executions())
        .isLessThanOrEqualTo(1);
  }
}
