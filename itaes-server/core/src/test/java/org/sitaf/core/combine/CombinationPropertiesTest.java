package org.sitaf.core.combine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class CombinationPropertiesTest {
  @Provide
  Arbitrary<CombinationProblem> problems() {
    return RandomModels.problems();
  }

  @Property(tries = 400)
  void every_possible_tuple_is_covered_and_no_condition_is_broken(
      @ForAll("problems") CombinationProblem problem) {
    CoveringArray array = combine(problem, Effort.FAST, 1);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
  }

  @Property(tries = 25)
  void the_search_keeps_what_the_growth_has_covered(
      @ForAll("problems") CombinationProblem problem) {
    CoveringArray fast = combine(problem, Effort.FAST, 1);
    CoveringArray searched = combine(problem, Effort.DEFAULT, 1);
    assertThat(CoveringCheck.findings(problem, searched)).isEmpty();
    assertThat(searched.tuples().impossible()).isEqualTo(fast.tuples().impossible());
  }

  @Property(tries = 300)
  void a_tuple_is_reported_impossible_only_if_no_allowed_row_holds_it(
      @ForAll("problems") CombinationProblem problem) {
    CoveringArray array = combine(problem, Effort.FAST, 1);
    List<int[]> allowed = allowedRows(problem);
    for (CoveringArray.Tuple tuple : array.tuples().examples()) {
      assertThat(allowed).as("%s", tuple).noneMatch(row -> holds(row, tuple));
    }
  }

  @Property(tries = 150)
  void the_same_seed_gives_the_same_rows(
      @ForAll("problems") CombinationProblem problem, @ForAll long seed) {
    assertThat(combine(problem, Effort.FAST, seed).rows())
        .isDeepEqualTo(combine(problem, Effort.FAST, seed).rows());
  }

  @Property(tries = 150)
  void rows_to_keep_stand_first_and_only_what_is_missing_is_added(
      @ForAll("problems") CombinationProblem problem, @ForAll long seed) {
    List<int[]> allowed = allowedRows(problem);
    List<int[]> kept = new ArrayList<>();
    for (int i = 0; i < Math.min(4, allowed.size()); i++) {
      int[] row = allowed.get((int) Math.floorMod(seed + 31L * i, (long) allowed.size())).clone();
      row[(int) Math.floorMod(seed + i, (long) row.length)] = CombinationProblem.FREE;
      kept.add(row);
    }
    CombinationProblem seeded = problem.withSeeds(kept);
    CoveringArray array = combine(seeded, Effort.FAST, 1);
    assertThat(CoveringCheck.findings(seeded, array)).isEmpty();
    CoveringArray again = combine(problem.withSeeds(Arrays.asList(array.rows())), Effort.FAST, 2);
    assertThat(again.rows()).isDeepEqualTo(array.rows());
  }

  private static CoveringArray combine(CombinationProblem problem, Effort effort, long seed) {
    return new TestDataCombinator().combine(problem, effort, seed, Progress.NONE);
  }

  private static boolean holds(int[] row, CoveringArray.Tuple tuple) {
    for (int i = 0; i < tuple.parameters().length; i++) {
      if (row[tuple.parameters()[i]] != tuple.values()[i]) {
        return false;
      }
    }
    return true;
  }

  /** Enumerates at most 5^7 rows. */
  private static List<int[]> allowedRows(CombinationProblem problem) {
    int[] levels = problem.levels();
    List<int[]> rows = new ArrayList<>();
    int[] row = new int[levels.length];
    while (true) {
      int[] here = row;
      boolean allowed =
          problem.constraints().stream()
              .allMatch(
                  c -> c.allowed().test(Arrays.stream(c.parameters()).map(p -> here[p]).toArray()));
      if (allowed) {
        rows.add(row.clone());
      }
      int i = row.length - 1;
      while (i >= 0 && row[i] == levels[i] - 1) {
        row[i--] = 0;
      }
      if (i < 0) {
        return rows;
      }
      row[i]++;
    }
  }
}
