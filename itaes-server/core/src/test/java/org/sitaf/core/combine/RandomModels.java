package org.sitaf.core.combine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Generates small models with mixed levels, mixed strength, clauses and arithmetic conditions. */
final class RandomModels {
  private RandomModels() {}

  static Arbitrary<CombinationProblem> problems() {
    Arbitrary<int[]> levels =
        Arbitraries.integers().between(1, 5).array(int[].class).ofMinSize(1).ofMaxSize(7);
    return levels.flatMap(RandomModels::problems);
  }

  private static Arbitrary<CombinationProblem> problems(int[] levels) {
    Arbitrary<List<Interaction>> interactions =
        interaction(levels.length).list().ofMinSize(1).ofMaxSize(3);
    Arbitrary<List<Constraint>> constraints = constraint(levels).list().ofMaxSize(6);
    return Combinators.combine(interactions, constraints)
        .as((i, c) -> new CombinationProblem(levels, i, c, List.of()));
  }

  private static Arbitrary<Interaction> interaction(int count) {
    Arbitrary<int[]> some =
        Arbitraries.of(indices(count)).set().ofMinSize(1).map(RandomModels::array);
    return Combinators.combine(Arbitraries.integers().between(1, 4), some)
        .as((t, parameters) -> new Interaction(t, parameters));
  }

  private static Arbitrary<Constraint> constraint(int[] levels) {
    Arbitrary<int[]> scope =
        Arbitraries.of(indices(levels.length))
            .set()
            .ofMinSize(1)
            .ofMaxSize(Math.min(3, levels.length))
            .map(RandomModels::array);
    Arbitrary<Constraint> clauses =
        Combinators.combine(scope, Arbitraries.integers().between(0, 1000))
            .as(
                (parameters, n) -> {
                  int[] values = new int[parameters.length];
                  for (int i = 0, rest = n; i < values.length; i++, rest /= 5) {
                    values[i] = rest % levels[parameters[i]];
                  }
                  return Constraint.forbid(parameters, values);
                });
    Arbitrary<Constraint> sums =
        Combinators.combine(scope, Arbitraries.integers().between(1, 6))
            .as((parameters, most) -> new Constraint(parameters, v -> sum(v) <= most));
    return Arbitraries.oneOf(clauses, clauses, sums);
  }

  static int sum(int[] values) {
    return Arrays.stream(values).sum();
  }

  private static List<Integer> indices(int count) {
    List<Integer> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(i);
    }
    return all;
  }

  private static int[] array(Iterable<Integer> values) {
    List<Integer> list = new ArrayList<>();
    values.forEach(list::add);
    return list.stream().mapToInt(Integer::intValue).toArray();
  }
}
