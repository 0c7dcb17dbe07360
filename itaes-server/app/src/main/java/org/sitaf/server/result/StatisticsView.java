package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Statistics of a result: processing times, and verdicts by parameter value. */
@Schema(name = "ResultStatistics")
record StatisticsView(
    @Schema(description = "absent if no case was timed") @Nullable Times times,
    @Schema(description = "in the order of the result's parameters") List<ByParameter> parameters,
    @Schema(
            description =
                "the two parameters whose values tell most about which cases fail; absent if no"
                    + " case or every case fails, or if there are no two with 2 to 30 values")
        @Nullable TellingPair tellingPair) {
  private static final int MAX_BARS = 40;
  private static final int MAX_POINTS = 400;

  /** Points that represent several cases are shown as box plots. */
  private static final int MAX_BOXES = 50;

  private static final int MAX_VALUES = 200;

  /** With fewer cases the 99th percentile is the maximum or next to it. */
  private static final int MIN_FOR_P99 = 200;

  @Schema(
      name = "TimeStatistics",
      description =
          "in microseconds, of the cases with verdict PASS or FAIL: the median of repeated calls,"
              + " else the time of the call, without the first call of a process")
  record Times(
      int count,
      double min,
      double max,
      double average,
      @Schema(description = "sample standard deviation") double standardDeviation,
      double p50,
      double p90,
      double p95,
      double p99,
      List<Bar> histogram,
      @Schema(description = "times by number of the case; a point may represent several cases")
          List<Point> overCases) {}

  @Schema(name = "HistogramBar")
  record Bar(
      @Schema(description = "inclusive") double from,
      @Schema(description = "exclusive, except for the last bar") double to,
      int count) {}

  @Schema(name = "TimePoint")
  record Point(
      int firstNo,
      int lastNo,
      double min,
      @Schema(description = "first quartile") double q1,
      double median,
      @Schema(description = "third quartile") double q3,
      double average,
      double max) {}

  @Schema(name = "VerdictsByParameter")
  record ByParameter(
      String name,
      @Schema(description = "numbers in ascending order, at most 200") List<ByValue> values,
      @Schema(description = "number of omitted values") int leftOut) {}

  @Schema(name = "VerdictsByValue")
  record ByValue(String value, int pass, int fail, int error, int dont) {}

  static StatisticsView of(TestResult result) {
    List<ByParameter> parameters = new ArrayList<>();
    for (int p = 0; p < result.parameters().size(); p++) {
      parameters.add(byParameter(result, p));
    }
    return new StatisticsView(times(result), parameters, TellingPair.of(result));
  }

  private static @Nullable Times times(TestResult result) {
    List<CaseResult> timed =
        result.cases().stream()
            .filter(c -> c.verdict() == Verdict.PASS || c.verdict() == Verdict.FAIL)
            .filter(c -> c.micros().isPresent())
            .toList();
    var summary = result.summary().times();
    if (summary != null && summary.first() != null) {
      timed = timed.stream().filter(c -> !isLeftOut(c)).toList();
    }
    if (timed.isEmpty() || summary == null) {
      return null;
    }
    double[] sorted = timed.stream().mapToDouble(StatisticsView::time).sorted().toArray();
    return new Times(
        sorted.length,
        summary.min(),
        summary.max(),
        summary.average(),
        summary.standardDeviation(),
        percentile(sorted, 0.50),
        percentile(sorted, 0.90),
        percentile(sorted, 0.95),
        percentile(sorted, 0.99),
        histogram(sorted),
        overCases(timed));
  }

  /** The percentile by the nearest-rank method. */
  private static double percentile(double[] sorted, double share) {
    int rank = (int) Math.ceil(share * sorted.length);
    return sorted[Math.max(0, Math.min(sorted.length - 1, rank - 1))];
  }

  /** Bars of equal width up to a high percentile; the last bar contains the outliers above. */
  private static List<Bar> histogram(double[] sorted) {
    double low = sorted[0];
    double high = percentile(sorted, sorted.length < MIN_FOR_P99 ? 0.95 : 0.99);
    double top = sorted[sorted.length - 1];
    if (high <= low) {
      return List.of(new Bar(low, top, sorted.length));
    }
    int bars = Math.max(1, Math.min(MAX_BARS, (int) Math.ceil(2 * Math.cbrt(sorted.length)) * 2));
    int[] counts = new int[bars];
    double width = (high - low) / bars;
    for (double time : sorted) {
      counts[Math.min(bars - 1, (int) ((time - low) / width))]++;
    }
    List<Bar> histogram = new ArrayList<>();
    for (int i = 0; i < bars; i++) {
      double to = i == bars - 1 ? Math.max(high, top) : low + (i + 1) * width;
      histogram.add(new Bar(low + i * width, to, counts[i]));
    }
    return histogram;
  }

  private static List<Point> overCases(List<CaseResult> timed) {
    List<CaseResult> ordered =
        timed.stream().sorted(Comparator.comparingInt(CaseResult::no)).toList();
    int step = ordered.size() <= MAX_POINTS ? 1 : (ordered.size() + MAX_BOXES - 1) / MAX_BOXES;
    List<Point> points = new ArrayList<>();
    for (int from = 0; from < ordered.size(); from += step) {
      List<CaseResult> range = ordered.subList(from, Math.min(ordered.size(), from + step));
      double[] times = range.stream().mapToDouble(StatisticsView::time).sorted().toArray();
      points.add(
          new Point(
              range.get(0).no(),
              range.get(range.size() - 1).no(),
              times[0],
              percentile(times, 0.25),
              percentile(times, 0.5),
              percentile(times, 0.75),
              Arrays.stream(times).average().orElseThrow(),
              times[times.length - 1]));
    }
    return points;
  }

  private static ByParameter byParameter(TestResult result, int parameter) {
    Map<String, int[]> counts = new LinkedHashMap<>();
    for (CaseResult testCase : result.cases()) {
      if (parameter < testCase.values().size()) {
        counts
            .computeIfAbsent(
                testCase.values().get(parameter), v -> new int[Verdict.values().length])[
            testCase.verdict().ordinal()]++;
      }
    }
    List<String> values = new ArrayList<>(counts.keySet());
    sort(values);
    List<ByValue> shown =
        values.stream()
            .limit(MAX_VALUES)
            .map(
                v -> {
                  int[] n = Objects.requireNonNull(counts.get(v));
                  return new ByValue(
                      v,
                      n[Verdict.PASS.ordinal()],
                      n[Verdict.FAIL.ordinal()],
                      n[Verdict.ERROR.ordinal()],
                      n[Verdict.DONT.ordinal()]);
                })
            .toList();
    return new ByParameter(
        result.parameters().get(parameter).name(), shown, values.size() - shown.size());
  }

  /** Sorts numbers by value, other texts as text. */
  static void sort(List<String> values) {
    try {
      Map<String, Double> numbers = new LinkedHashMap<>();
      values.forEach(v -> numbers.put(v, Double.valueOf(v)));
      values.sort(Comparator.comparing(numbers::get));
    } catch (NumberFormatException e) {
      values.sort(Comparator.naturalOrder());
    }
  }

  /** Whether the summary leaves out the only call of the case, the first of its process. */
  private static boolean isLeftOut(CaseResult testCase) {
    boolean repeated = testCase.repeated() != null && testCase.repeated().median() != null;
    return !repeated && testCase.time() != null && testCase.time().cold();
  }

  private static double time(CaseResult testCase) {
    return testCase.micros().getAsDouble();
  }
}
