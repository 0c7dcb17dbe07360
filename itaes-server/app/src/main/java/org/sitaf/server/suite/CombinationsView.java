package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.error.RequestException;

/** The pairs of values in the cases of a suite. */
@Schema(name = "Combinations")
record CombinationsView(
    List<ValuesView> parameters,
    @Schema(description = "a pair of parameters each, in the order of the parameters")
        List<PairView> pairs,
    @Schema(description = "absent if no pair was requested") @Nullable CountsView counts) {
  /** The portal cannot draw the pairs of more parameters. */
  private static final int MAX_PARAMETERS = 60;

  @Schema(name = "ParameterValues")
  record ValuesView(
      String name,
      @Schema(description = "values in the cases; numbers in ascending order")
          List<String> values) {}

  @Schema(name = "PairCoverage")
  record PairView(
      @Schema(description = "index of a parameter, from 0") int first,
      @Schema(description = "index of a parameter, from 0") int second,
      @Schema(description = "number of pairs of values in the cases") int covered,
      @Schema(description = "number of possible pairs of values") int possible) {}

  @Schema(name = "PairCounts")
  record CountsView(
      int first,
      int second,
      @Schema(description = "number of cases by index of the first's value, then of the second's")
          List<List<Integer>> cases) {}

  static CombinationsView of(TestSuite suite, @Nullable Integer first, @Nullable Integer second) {
    int width = suite.parameters().size();
    List<ValuesView> parameters = new ArrayList<>();
    int[][] codes = new int[width][];
    for (int p = 0; p < width; p++) {
      List<String> values = values(suite, p);
      parameters.add(new ValuesView(suite.parameters().get(p).name(), values));
      codes[p] = codes(suite, p, values);
    }
    List<PairView> pairs = new ArrayList<>();
    for (int a = 0; a < Math.min(width, MAX_PARAMETERS); a++) {
      for (int b = a + 1; b < Math.min(width, MAX_PARAMETERS); b++) {
        int[][] counts = count(codes, parameters, a, b);
        int covered = 0;
        for (int[] row : counts) {
          for (int cell : row) {
            covered += cell > 0 ? 1 : 0;
          }
        }
        pairs.add(
            new PairView(
                a,
                b,
                covered,
                parameters.get(a).values().size() * parameters.get(b).values().size()));
      }
    }
    CountsView counts = null;
    if (first != null && second != null) {
      if (first < 0 || second < 0 || first >= width || second >= width) {
        throw RequestException.malformed("first and second must be indices of parameters, from 0.");
      }
      List<List<Integer>> rows = new ArrayList<>();
      for (int[] row : count(codes, parameters, first, second)) {
        rows.add(java.util.Arrays.stream(row).boxed().toList());
      }
      counts = new CountsView(first, second, rows);
    }
    return new CombinationsView(parameters, pairs, counts);
  }

  private static List<String> values(TestSuite suite, int parameter) {
    List<String> values =
        new ArrayList<>(
            suite.cases().stream().map(c -> c.values().get(parameter)).distinct().toList());
    try {
      Map<String, Double> numbers = new LinkedHashMap<>();
      values.forEach(v -> numbers.put(v, Double.valueOf(v)));
      values.sort(Comparator.comparing(numbers::get));
    } catch (NumberFormatException e) {
      values.sort(Comparator.naturalOrder());
    }
    return values;
  }

  private static int[] codes(TestSuite suite, int parameter, List<String> values) {
    Map<String, Integer> code = new LinkedHashMap<>();
    values.forEach(v -> code.put(v, code.size()));
    int[] codes = new int[suite.cases().size()];
    int at = 0;
    for (TestCase testCase : suite.cases()) {
      codes[at++] = code.getOrDefault(testCase.values().get(parameter), 0);
    }
    return codes;
  }

  private static int[][] count(int[][] codes, List<ValuesView> parameters, int a, int b) {
    int[][] counts = new int[parameters.get(a).values().size()][parameters.get(b).values().size()];
    for (int i = 0; i < codes[a].length; i++) {
      counts[codes[a][i]][codes[b][i]]++;
    }
    return counts;
  }
}
