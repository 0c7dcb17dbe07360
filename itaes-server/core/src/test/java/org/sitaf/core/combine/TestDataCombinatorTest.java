package org.sitaf.core.combine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Tag("slow")
class TestDataCombinatorTest {
  @ParameterizedTest(name = "{0} at {1}-way has at most {2} rows")
  @CsvSource({
    "5^3, 2, 25",
    "3^4, 2, 9",
    "3^13, 2, 15",
    "7^3, 2, 49",
    "8^9, 2, 64",
    "9^10, 2, 81",
    "4^10, 2, 25",
    "5^10, 2, 38",
    "4^15 3^17 2^29, 2, 29",
    "4^1 3^39 2^35, 2, 21",
    "2^100, 2, 10",
    "10^2 4^1 3^2 2^7, 2, 100",
    "4^6, 3, 64",
    "10^20, 2, 180",
    "10^12, 2, 120",
    "2^5, 4, 16",
    "5^3, 1, 5",
  })
  void known_sizes_are_reached(String model, int strength, int most) {
    assertSize(model, strength, most);
  }

  @Tag("long")
  @ParameterizedTest(name = "{0} at {1}-way has at most {2} rows")
  @CsvSource({"3^13, 3, 45", "10^20, 3, 2420"})
  void known_sizes_of_large_3_way_arrays_are_reached(String model, int strength, int most) {
    assertSize(model, strength, most);
  }

  private static void assertSize(String model, int strength, int most) {
    CombinationProblem problem = CombinationProblem.tWay(strength, levels(model));
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
    assertThat(array.size()).isLessThanOrEqualTo(most);
  }

  @Test
  void all_combinations_are_the_product_in_ascending_order() {
    CoveringArray array = combine(CombinationProblem.all(2, 1, 3), Effort.DEFAULT);
    assertThat(array.rows())
        .isDeepEqualTo(
            new int[][] {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 0}, {1, 0, 1}, {1, 0, 2}});
    assertThat(array.optimal()).isTrue();
  }

  @Test
  void all_combinations_under_a_condition_leave_out_what_breaks_it() {
    CombinationProblem problem =
        CombinationProblem.all(4, 4)
            .withConstraints(List.of(new Constraint(new int[] {1, 0}, v -> v[0] < v[1])));
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(array.size()).isEqualTo(6);
    assertThat(array.tuples().impossible()).isEqualTo(10);
    assertThat(array.rows())
        .isDeepEqualTo(new int[][] {{1, 0}, {2, 0}, {2, 1}, {3, 0}, {3, 1}, {3, 2}});
  }

  @Test
  void a_product_that_would_explode_is_refused_with_its_exact_size() {
    assertThatThrownBy(() -> combine(CombinationProblem.all(levels("10^20")), Effort.DEFAULT))
        .isInstanceOfSatisfying(
            TooManyCombinationsException.class,
            e -> assertThat(e.count()).isEqualTo(BigInteger.TEN.pow(20)))
        .hasMessageContaining("100000000000000000000");
  }

  @Test
  void a_strength_with_too_many_tuples_is_refused_beforehand() {
    assertThatThrownBy(() -> combine(CombinationProblem.tWay(6, levels("2^100")), Effort.DEFAULT))
        .isInstanceOf(TooManyCombinationsException.class);
  }

  @Test
  void a_seed_that_breaks_a_condition_is_refused_and_the_rest_is_covered() {
    CombinationProblem problem =
        CombinationProblem.tWay(2, 2, 2, 2)
            .withConstraints(List.of(Constraint.forbid(new int[] {0, 2}, new int[] {1, 1})))
            .withSeeds(List.of(new int[] {0, 0, 0}, new int[] {1, -1, 1}));
    CoveringArray array = combine(problem, Effort.FAST);
    assertThat(array.rejectedSeeds()).containsExactly(1);
    assertThat(array.rows()[0]).containsExactly(0, 0, 0);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
  }

  @Test
  void a_seed_that_no_allowed_row_completes_is_refused() {
    // 0 -> 1 -> not 2, and 0 -> 2: value 1 of parameter 0 is in no allowed row.
    CombinationProblem problem =
        CombinationProblem.tWay(2, 2, 2, 2)
            .withConstraints(
                List.of(
                    Constraint.forbid(new int[] {0, 1}, new int[] {1, 0}),
                    Constraint.forbid(new int[] {1, 2}, new int[] {1, 1}),
                    Constraint.forbid(new int[] {0, 2}, new int[] {1, 0})))
            .withSeeds(List.of(new int[] {1, -1, -1}));
    assertThat(combine(problem, Effort.FAST).rejectedSeeds()).containsExactly(0);
  }

  @Test
  void conditions_that_contradict_each_other_leave_no_row_also_for_what_they_do_not_touch() {
    // Pairs of values are forbidden, but no single value: only a search finds the contradiction.
    List<Constraint> none = new ArrayList<>();
    for (int a = 0; a < 2; a++) {
      for (int b = 0; b < 2; b++) {
        none.add(Constraint.forbid(new int[] {0, 1}, new int[] {a, b}));
      }
    }
    CombinationProblem problem =
        new CombinationProblem(
            new int[] {2, 2, 3}, List.of(new Interaction(1, new int[] {2})), none, List.of());
    CoveringArray array = combine(problem, Effort.FAST);
    assertThat(array.size()).isZero();
    assertThat(array.tuples().impossible()).isEqualTo(3);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
  }

  @Test
  void tuples_that_are_impossible_by_implication_are_reported() {
    CombinationProblem problem =
        CombinationProblem.tWay(2, 2, 2, 2, 2)
            .withConstraints(
                List.of(
                    Constraint.forbid(new int[] {0, 1}, new int[] {1, 0}),
                    Constraint.forbid(new int[] {1, 2}, new int[] {1, 0})));
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(array.tuples().examples().stream().map(CoveringArray.Tuple::toString))
        .containsExactlyInAnyOrder("[0, 1]=[1, 0]", "[1, 2]=[1, 0]", "[0, 2]=[1, 0]");
    assertThat(array.tuples().impossible()).isEqualTo(3);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
  }

  @Test
  void a_condition_too_large_for_a_table_is_kept() {
    int[] levels = levels("10^8");
    CombinationProblem problem =
        CombinationProblem.tWay(2, levels)
            .withConstraints(
                List.of(
                    new Constraint(
                        new int[] {0, 1, 2, 3, 4, 5, 6, 7}, v -> Arrays.stream(v).sum() % 2 == 0)));
    CoveringArray array = combine(problem, Effort.FAST);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
    assertThat(array.tuples().impossible()).isZero();
  }

  @Test
  void conditions_that_allow_nothing_leave_no_row_and_all_tuples_impossible() {
    CombinationProblem problem =
        CombinationProblem.tWay(2, 2, 2, 3)
            .withConstraints(List.of(new Constraint(new int[] {0}, v -> false)));
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(array.size()).isZero();
    assertThat(array.tuples().impossible()).isEqualTo(4 + 6 + 6);
  }

  @Test
  void the_bound_counts_impossible_tuples_beyond_those_listed() {
    CombinationProblem problem =
        CombinationProblem.tWay(2, 40, 40, 2)
            .withConstraints(
                List.of(new Constraint(new int[] {0, 1}, v -> Math.abs(v[0] - v[1]) <= 3)));
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(array.tuples().examples()).hasSize(1000);
    assertThat(array.tuples().impossible()).isEqualTo(1600 - 268);
    assertThat(array.size()).isEqualTo(268);
    assertThat(array.optimal()).isTrue();
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
  }

  @Test
  void a_stronger_interaction_among_some_parameters_is_covered_beside_the_pairs() {
    CombinationProblem problem =
        new CombinationProblem(
            levels("3^6"),
            List.of(
                new Interaction(2, new int[] {0, 1, 2, 3, 4, 5}),
                new Interaction(3, new int[] {5, 1, 3})),
            List.of(),
            List.of());
    CoveringArray array = combine(problem, Effort.DEFAULT);
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
    assertThat(array.size()).isEqualTo(27);
  }

  @Test
  void the_check_sees_a_missing_tuple_a_broken_condition_and_a_row_twice() {
    CombinationProblem problem = CombinationProblem.tWay(2, 2, 2, 2);
    CoveringArray array = combine(problem, Effort.DEFAULT);
    int[][] rows = array.rows();
    int[][] fewer = Arrays.copyOf(rows, rows.length - 1);
    int[][] more = Arrays.copyOf(rows, rows.length + 1);
    more[rows.length] = rows[0];
    CombinationProblem stricter =
        problem.withConstraints(List.of(Constraint.forbid(new int[] {0, 1}, new int[] {0, 0})));
    assertThat(CoveringCheck.findings(problem, array)).isEmpty();
    assertThat(CoveringCheck.findings(problem, with(array, fewer))).isNotEmpty();
    assertThat(CoveringCheck.findings(problem, with(array, more))).hasSize(1);
    assertThat(CoveringCheck.findings(stricter, array)).isNotEmpty();
  }

  @Test
  void a_model_without_anything_to_vary_has_one_row() {
    assertThat(combine(CombinationProblem.tWay(2, 1, 1), Effort.DEFAULT).rows())
        .isDeepEqualTo(new int[][] {{0, 0}});
  }

  private static CoveringArray with(CoveringArray array, int[][] rows) {
    return new CoveringArray(rows, array.tuples(), false, List.of());
  }

  private static CoveringArray combine(CombinationProblem problem, Effort effort) {
    return new TestDataCombinator().combine(problem, effort, 1, Progress.NONE);
  }

  /** Reads {@code 4^15 3^17}. */
  static int[] levels(String model) {
    return Pattern.compile("(\\d+)\\^(\\d+)")
        .matcher(model)
        .results()
        .flatMapToInt(
            power ->
                IntStream.generate(() -> Integer.parseInt(power.group(1)))
                    .limit(Integer.parseInt(power.group(2))))
        .toArray();
  }
}
