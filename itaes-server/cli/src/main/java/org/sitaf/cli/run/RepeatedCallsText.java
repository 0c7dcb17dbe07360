package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;

/** Describes which calls the times of a result come from. */
public final class RepeatedCallsText {
  private static final int MAX_DIFFERING = 5;

  private RepeatedCallsText() {}

  /** The 95 % interval of the median of a case. */
  static String interval(@Nullable RepeatedCalls repeated) {
    return repeated == null || repeated.low() == null || repeated.high() == null
        ? "-"
        : ResultTable.number(repeated.low()) + ".." + ResultTable.number(repeated.high());
  }

  static void print(TestResult result, PrintWriter out) {
    Summary.Times times = result.summary().times();
    if (times != null && times.first() != null) {
      out.printf(
          Locale.ROOT,
          "  not included: the first call of the process, which also loads and compiles code (%s us)%n",
          ResultTable.number(times.first()));
    }
    List<CaseResult> repeated = result.cases().stream().filter(c -> c.repeated() != null).toList();
    IntSummaryStatistics calls =
        repeated.stream()
            .mapToInt(c -> Objects.requireNonNull(c.repeated()).calls())
            .summaryStatistics();
    if (calls.getCount() > 0) {
      out.printf(
          Locale.ROOT,
          "  the time of a case is the median of %s calls after the first and %d more to warm up%n",
          calls.getMin() == calls.getMax()
              ? Integer.toString(calls.getMax())
              : calls.getMin() + " to " + calls.getMax(),
          Objects.requireNonNull(repeated.get(0).repeated()).warmUp());
    }
    List<CaseResult> differing =
        repeated.stream().filter(c -> Objects.requireNonNull(c.repeated()).differ()).toList();
    if (!differing.isEmpty()) {
      out.printf(
          Locale.ROOT,
          "repeated calls differ in %d %s; the first call decides the verdict:%n",
          differing.size(),
          differing.size() == 1 ? "case" : "cases");
      for (CaseResult c : differing.subList(0, Math.min(MAX_DIFFERING, differing.size()))) {
        out.println(
            "  case "
                + c.no()
                + ", "
                + Printable.line(Objects.requireNonNull(c.repeated()).differs()));
      }
      if (differing.size() > MAX_DIFFERING) {
        out.println("  and " + (differing.size() - MAX_DIFFERING) + " more");
      }
    }
  }
}
