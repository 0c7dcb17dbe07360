package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * The two parameters whose values tell most about which cases fail: those with the largest mutual
 * information of their values and the verdict. The estimate is corrected for the number of values
 * (G. A. Miller, Note on the bias of information estimates, 1955), as a pair with as many values as
 * cases would tell everything.
 */
@Schema(name = "TellingPair")
record TellingPair(
    @Schema(description = "name of a parameter") String first,
    @Schema(description = "name of a parameter") String second,
    @Schema(description = "numbers in ascending order") List<String> firstValues,
    @Schema(description = "numbers in ascending order") List<String> secondValues,
    @Schema(description = "pairs of values that occur") List<Cell> cells) {
  /** A heat map with more values per axis cannot be read. */
  private static final int MAX_VALUES = 30;

  /** Of more parameters, those that tell most on their own are combined. */
  private static final int MAX_PARAMETERS = 12;

  /** Cases that decide which pair is chosen; more do not change the choice. */
  private static final int MAX_SAMPLE = 20_000;

  @Schema(name = "TellingCell")
  record Cell(
      @Schema(description = "index in firstValues") int first,
      @Schema(description = "index in secondValues") int second,
      int pass,
      int fail,
      int error,
      int dont) {}

  /** Returns null if no case fails, all fail, or fewer than two parameters have few values. */
  static @Nullable TellingPair of(TestResult result) {
    List<CaseResult> executed =
        result.cases().stream().filter(c -> c.verdict() != Verdict.DONT).toList();
    long failing = executed.stream().filter(TellingPair::isFailure).count();
    if (failing == 0 || failing == executed.size()) {
      return null;
    }
    int step = Math.max(1, executed.size() / MAX_SAMPLE);
    List<CaseResult> sample = new ArrayList<>();
    for (int i = 0; i < executed.size(); i += step) {
      sample.add(executed.get(i));
    }
    List<Axis> axes = new ArrayList<>();
    for (int p = 0; p < result.parameters().size(); p++) {
      Axis axis = Axis.of(result, p);
      if (axis != null) {
        axes.add(axis);
      }
    }
    if (axes.size() > MAX_PARAMETERS) {
      axes =
          axes.stream()
              .sorted(
                  Comparator.comparingDouble((Axis a) -> information(sample, a, Axis.NONE))
                      .reversed())
              .limit(MAX_PARAMETERS)
              .sorted(Comparator.comparingInt(Axis::parameter))
              .toList();
    }
    TellingPair best = null;
    double most = Double.NEGATIVE_INFINITY;
    for (int a = 0; a < axes.size(); a++) {
      for (int b = a + 1; b < axes.size(); b++) {
        double information = information(sample, axes.get(a), axes.get(b));
        if (information > most) {
          most = information;
          best =
              new TellingPair(
                  name(result, axes.get(a)),
                  name(result, axes.get(b)),
                  axes.get(a).values(),
                  axes.get(b).values(),
                  List.of());
        }
      }
    }
    return best == null ? null : best.counted(result);
  }

  private static String name(TestResult result, Axis axis) {
    return result.parameters().get(axis.parameter()).name();
  }

  private TellingPair counted(TestResult result) {
    Axis a = axisOf(result, first);
    Axis b = axisOf(result, second);
    int[][] counts = new int[a.size() * b.size()][];
    for (CaseResult testCase : result.cases()) {
      int cell = a.indexIn(testCase) * b.size() + b.indexIn(testCase);
      if (counts[cell] == null) {
        counts[cell] = new int[Verdict.values().length];
      }
      counts[cell][testCase.verdict().ordinal()]++;
    }
    List<Cell> cells = new ArrayList<>();
    for (int i = 0; i < counts.length; i++) {
      int[] n = counts[i];
      if (n != null) {
        cells.add(
            new Cell(
                i / b.size(),
                i % b.size(),
                n[Verdict.PASS.ordinal()],
                n[Verdict.FAIL.ordinal()],
                n[Verdict.ERROR.ordinal()],
                n[Verdict.DONT.ordinal()]));
      }
    }
    return new TellingPair(first, second, firstValues, secondValues, cells);
  }

  private static Axis axisOf(TestResult result, String name) {
    for (int p = 0; p < result.parameters().size(); p++) {
      Axis axis = result.parameters().get(p).name().equals(name) ? Axis.of(result, p) : null;
      if (axis != null) {
        return axis;
      }
    }
    throw new IllegalStateException(name);
  }

  /** Mutual information of the pair of values and of failing, in nats, less its expected bias. */
  private static double information(List<CaseResult> sample, Axis a, Axis b) {
    int[] failing = new int[a.size() * b.size()];
    int[] all = new int[failing.length];
    int totalFailing = 0;
    for (CaseResult testCase : sample) {
      int cell = a.indexIn(testCase) * b.size() + b.indexIn(testCase);
      all[cell]++;
      if (isFailure(testCase)) {
        failing[cell]++;
        totalFailing++;
      }
    }
    double n = sample.size();
    double information = 0;
    int occupied = 0;
    for (int cell = 0; cell < all.length; cell++) {
      if (all[cell] > 0) {
        occupied++;
        information += term(failing[cell], all[cell], totalFailing, n);
        information += term(all[cell] - failing[cell], all[cell], n - totalFailing, n);
      }
    }
    return information - (occupied - 1) / (2 * n);
  }

  private static double term(double joint, double cell, double verdict, double n) {
    return joint == 0 ? 0 : joint / n * Math.log(joint * n / (cell * verdict));
  }

  private static boolean isFailure(CaseResult result) {
    return result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
  }

  /** A parameter with few values. */
  private record Axis(int parameter, List<String> values, Map<String, Integer> indices) {
    /** A parameter with one value. */
    static final Axis NONE = new Axis(-1, List.of(""), Map.of("", 0));

    /** Returns null if the parameter never varies or has too many values. */
    static @Nullable Axis of(TestResult result, int parameter) {
      Map<String, Integer> indices = new LinkedHashMap<>();
      for (CaseResult testCase : result.cases()) {
        if (parameter >= testCase.values().size()) {
          return null;
        }
        indices.put(testCase.values().get(parameter), 0);
        if (indices.size() > MAX_VALUES) {
          return null;
        }
      }
      if (indices.size() < 2) {
        return null;
      }
      List<String> values = new ArrayList<>(indices.keySet());
      StatisticsView.sort(values);
      for (int i = 0; i < values.size(); i++) {
        indices.put(values.get(i), i);
      }
      return new Axis(parameter, List.copyOf(values), indices);
    }

    int size() {
      return values.size();
    }

    int indexIn(CaseResult testCase) {
      return parameter < 0 ? 0 : indices.getOrDefault(testCase.values().get(parameter), 0);
    }
  }
}
