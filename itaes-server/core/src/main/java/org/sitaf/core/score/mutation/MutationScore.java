package org.sitaf.core.score.mutation;

import java.util.List;
import org.sitaf.core.score.SpecificationScore.Survivor;

/**
 * How many mutations of the sources a suite notices.
 *
 * @param made number of mutations that could be compiled and executed
 * @param noticed number of mutations with which a case that passes without them does not pass
 * @param unchanged mutations that change no recorded value: no case reaches their effect, or they
 *     have none
 * @param survivors the other mutations, which change a value that nothing looks at
 */
public record MutationScore(
    int made, int noticed, List<Mutation> unchanged, List<Survivor> survivors) {
  public MutationScore {
    unchanged = List.copyOf(unchanged);
    survivors = List.copyOf(survivors);
  }

  /** The share of the mutations with an effect that is noticed, from 0 to 1; 1 without such. */
  public double share() {
    int effective = made - unchanged.size();
    return effective == 0 ? 1 : (double) noticed / effective;
  }
}
