package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A combination problem. Parameter {@code p} has the values {@code 0 .. levels[p]-1}.
 *
 * @param levels number of values of each parameter, at least 1
 * @param interactions the tuples to cover; several interactions mean mixed strength
 * @param constraints conditions that every row satisfies
 * @param seeds rows to keep, in this order, with one value per parameter; {@link #FREE} if the
 *     generator may choose the value
 */
public record CombinationProblem(
    int[] levels, List<Interaction> interactions, List<Constraint> constraints, List<int[]> seeds) {

  /** In a seed: the generator chooses the value of this parameter. */
  public static final int FREE = -1;

  public CombinationProblem {
    levels = levels.clone();
    interactions = List.copyOf(interactions);
    constraints = List.copyOf(constraints);
    seeds = seeds.stream().map(int[]::clone).toList();
    for (int p = 0; p < levels.length; p++) {
      if (levels[p] < 1) {
        throw new IllegalArgumentException("parameter " + p + " has no value to combine");
      }
    }
    for (Interaction interaction : interactions) {
      checkParameters("an interaction", interaction.parameters(), levels.length);
    }
    for (Constraint constraint : constraints) {
      checkParameters("a constraint", constraint.parameters(), levels.length);
    }
    for (int i = 0; i < seeds.size(); i++) {
      checkSeed(i, seeds.get(i), levels);
    }
  }

  /** All tuples of {@code strength} values of all parameters, without constraints. */
  public static CombinationProblem tWay(int strength, int... levels) {
    int[] all = IntStream.range(0, levels.length).toArray();
    return new CombinationProblem(
        levels, List.of(new Interaction(strength, all)), List.of(), List.of());
  }

  /** All combinations of all values. */
  public static CombinationProblem all(int... levels) {
    return tWay(Math.max(1, levels.length), levels);
  }

  /** A copy with other constraints. */
  public CombinationProblem withConstraints(List<Constraint> replaced) {
    return new CombinationProblem(levels, interactions, replaced, seeds);
  }

  /** A copy with other seeds. */
  public CombinationProblem withSeeds(List<int[]> replaced) {
    return new CombinationProblem(levels, interactions, constraints, replaced);
  }

  @Override
  public int[] levels() {
    return levels.clone();
  }

  @Override
  public List<int[]> seeds() {
    return seeds.stream().map(int[]::clone).toList();
  }

  private static void checkParameters(String what, int[] parameters, int count) {
    for (int p : parameters) {
      if (p < 0 || p >= count) {
        throw new IllegalArgumentException(
            what + " uses parameter " + p + ", but there are " + count + " (from 0)");
      }
    }
  }

  private static void checkSeed(int index, int[] seed, int[] levels) {
    boolean fits = seed.length == levels.length;
    for (int p = 0; fits && p < seed.length; p++) {
      fits = seed[p] >= FREE && seed[p] < levels[p];
    }
    if (!fits) {
      throw new IllegalArgumentException(
          "seed row "
              + index
              + " "
              + Arrays.toString(seed)
              + " does not fit the levels "
              + Arrays.toString(levels));
    }
  }
}
