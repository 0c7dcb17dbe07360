package org.sitaf.core.combine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Checks a covering array against its problem. Simple and independent: shares no code with the
 * generator.
 */
public final class CoveringCheck {
  private CoveringCheck() {}

  /**
   * Returns at most 1000 problems. The array is correct if each required tuple is covered or
   * impossible, no row violates a constraint, the rows begin with the seeds, and no rejected seed
   * and no tuple reported as impossible is part of an allowed row. Impossibility is checked by
   * exhaustive search.
   */
  public static List<String> findings(CombinationProblem problem, CoveringArray array) {
    List<String> findings = new ArrayList<>();
    int[][] rows = array.rows();
    checkRows(problem, allowedSeeds(problem, array), rows, findings);
    Set<List<Integer>> impossible = new HashSet<>();
    for (CoveringArray.Tuple tuple : array.tuples().examples()) {
      impossible.add(code(tuple.parameters(), tuple.values()));
    }
    ExhaustiveSearch exhaustiveSearch = new ExhaustiveSearch(problem);
    checkRejections(problem, array, exhaustiveSearch, findings);
    for (Interaction interaction : problem.interactions()) {
      int[] parameters = interaction.parameters();
      int strength = Math.min(interaction.strength(), parameters.length);
      for (int[] set : subsets(parameters, strength)) {
        for (int[] values : missing(problem.levels(), set, rows)) {
          if (!containsImpossible(set, values, impossible) && exhaustiveSearch.finds(set, values)) {
            add(findings, "not covered: " + Arrays.toString(set) + "=" + Arrays.toString(values));
          }
        }
      }
    }
    return findings;
  }

  private static List<int[]> allowedSeeds(CombinationProblem problem, CoveringArray array) {
    return IntStream.range(0, problem.seeds().size())
        .filter(i -> !array.rejectedSeeds().contains(i))
        .mapToObj(problem.seeds()::get)
        .toList();
  }

  private static void checkRejections(
      CombinationProblem problem,
      CoveringArray array,
      ExhaustiveSearch exhaustiveSearch,
      List<String> findings) {
    for (int rejected : array.rejectedSeeds()) {
      int[] seed = problem.seeds().get(rejected);
      int[] parameters = IntStream.range(0, seed.length).filter(p -> seed[p] >= 0).toArray();
      int[] values = IntStream.of(parameters).map(p -> seed[p]).toArray();
      if (exhaustiveSearch.finds(parameters, values)) {
        add(findings, "seed " + rejected + " was rejected, but an allowed row contains it");
      }
    }
    for (CoveringArray.Tuple tuple : array.tuples().examples()) {
      if (exhaustiveSearch.finds(tuple.parameters(), tuple.values())) {
        add(findings, "reported as impossible, but an allowed row contains it: " + tuple);
      }
    }
  }

  private static void checkRows(
      CombinationProblem problem, List<int[]> seeds, int[][] rows, List<String> findings) {
    int[] levels = problem.levels();
    Set<List<Integer>> seen = new HashSet<>();
    for (int r = 0; r < rows.length; r++) {
      int[] row = rows[r];
      for (int p = 0; p < levels.length; p++) {
        if (row[p] < 0 || row[p] >= levels[p]) {
          add(findings, "row " + r + " has no value " + row[p] + " of parameter " + p);
        }
        if (r < seeds.size() && seeds.get(r)[p] >= 0 && seeds.get(r)[p] != row[p]) {
          add(findings, "row " + r + " differs from its seed");
        }
      }
      for (Constraint constraint : problem.constraints()) {
        int[] values = Arrays.stream(constraint.parameters()).map(p -> row[p]).toArray();
        if (!constraint.allowed().test(values)) {
          add(findings, "row " + r + " violates a constraint: " + Arrays.toString(row));
        }
      }
      if (!seen.add(Arrays.stream(row).boxed().toList()) && r >= seeds.size()) {
        add(findings, "row " + r + " is a duplicate: " + Arrays.toString(row));
      }
    }
    if (rows.length < seeds.size()) {
      add(findings, "there are fewer rows than seeds");
    }
  }

  private static void add(List<String> findings, String finding) {
    if (findings.size() < 1000) {
      findings.add(finding);
    }
  }

  private static List<int[]> missing(int[] levels, int[] set, int[][] rows) {
    int product = 1;
    for (int p : set) {
      product *= levels[p];
    }
    boolean[] present = new boolean[product];
    for (int[] row : rows) {
      int index = 0;
      for (int p : set) {
        index = index * levels[p] + row[p];
      }
      present[index] = true;
    }
    List<int[]> missing = new ArrayList<>();
    for (int index = 0; index < product; index++) {
      if (!present[index]) {
        int[] values = new int[set.length];
        for (int i = set.length - 1, rest = index; i >= 0; rest /= levels[set[i]], i--) {
          values[i] = rest % levels[set[i]];
        }
        missing.add(values);
      }
    }
    return missing;
  }

  /** Whether the tuple or a part of it is impossible. */
  private static boolean containsImpossible(
      int[] set, int[] values, Set<List<Integer>> impossible) {
    for (int members = 1; members < 1 << set.length; members++) {
      int size = Integer.bitCount(members);
      int[] someColumns = new int[size];
      int[] someValues = new int[size];
      for (int i = 0, n = 0; i < set.length; i++) {
        if ((members >> i & 1) == 1) {
          someColumns[n] = set[i];
          someValues[n++] = values[i];
        }
      }
      if (impossible.contains(code(someColumns, someValues))) {
        return true;
      }
    }
    return false;
  }

  private static List<Integer> code(int[] parameters, int[] values) {
    List<Integer> code = new ArrayList<>();
    for (int i = 0; i < parameters.length; i++) {
      code.add(parameters[i]);
      code.add(values[i]);
    }
    return code;
  }

  private static List<int[]> subsets(int[] of, int size) {
    List<int[]> all = new ArrayList<>();
    subsets(of, 0, new int[size], 0, all);
    return all;
  }

  private static void subsets(int[] of, int next, int[] chosen, int depth, List<int[]> out) {
    if (depth == chosen.length) {
      out.add(chosen.clone());
      return;
    }
    for (int i = next; i < of.length; i++) {
      chosen[depth] = of[i];
      subsets(of, i + 1, chosen, depth + 1, out);
    }
  }
}
