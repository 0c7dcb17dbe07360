package org.sitaf.server.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Verdict;

/** The line of a case in the REST interface. */
@Schema(name = "CaseHistory")
record CaseHistoryView(
    @Schema(description = "the build in which the case has the number") String buildId,
    int no,
    @Schema(description = "the inputs, in the order of the model") List<String> parameters,
    @Schema(description = "in the order of the parameters, shortened to 200 characters")
        List<String> values,
    @Schema(description = "number of steps of a sequence; 0 if the case is one call") int steps,
    @Schema(description = "what the items are") CaseHistories.Points by,
    @Schema(description = "the newest first") List<PointView> items,
    @Schema(description = "from 0") int page,
    @Schema(description = "at most 200") int size,
    @Schema(description = "number of items on all pages") long total) {
  private static final int MAX_VALUE = 200;
  private static final int MAX_VALUES = 50;
  private static final int MAX_TEXT = 1000;

  /** The margin that decides: the smallest one of the conditions over time. */
  @Schema(name = "SmallestMargin")
  record MarginView(
      @Schema(description = "name of the condition over time") String condition,
      @Schema(description = "quantitative robustness: a number, Infinity or -Infinity")
          String value) {
    static @Nullable MarginView of(CaseResult result) {
      return result.trajectories().stream()
          .filter(t -> t.margin() != null)
          .min((a, b) -> Double.compare(margin(a.margin()), margin(b.margin())))
          .map(t -> new MarginView(t.name(), String.valueOf(t.margin())))
          .orElse(null);
    }

    private static double margin(@Nullable Double margin) {
      return margin == null ? Double.NaN : margin;
    }
  }

  @Schema(name = "CaseTime", description = "time of the component, in microseconds")
  record TimeView(
      @Schema(description = "median of the repeated calls, else the time of the call")
          double medianUs,
      @Schema(description = "number of repeated calls; 0 if calls were not repeated") int calls,
      @Schema(description = "lower end of the 95 % interval of the median; absent below 6 calls")
          @Nullable Double lowUs,
      @Schema(description = "upper end of the 95 % interval of the median; absent below 6 calls")
          @Nullable Double highUs) {
    static @Nullable TimeView of(CaseResult result) {
      if (result.micros().isEmpty()) {
        return null;
      }
      RepeatedCalls repeated = result.repeated();
      return new TimeView(
          result.micros().getAsDouble(),
          repeated == null ? 0 : repeated.calls(),
          repeated == null ? null : repeated.low(),
          repeated == null ? null : repeated.high());
    }
  }

  @Schema(name = "CasePoint", description = "a case in a commit or a build")
  record PointView(
      @Schema(description = "id of the commit; absent if it is not known") @Nullable String commit,
      @Schema(description = "first line of the commit's message; absent unless from Git")
          @Nullable String subject,
      @Schema(description = "absent unless from Git") @Nullable String author,
      @Schema(description = "when the commit was made, or the build was requested") Instant at,
      @Schema(description = "whether a force-push has removed the commit from the branch")
          boolean replaced,
      @Schema(description = "absent without a build") @Nullable String buildId,
      @Schema(description = "the commit whose result was taken over; absent if there is none")
          @Nullable String takenFrom,
      @Schema(description = "whether the verdicts cannot be trusted") boolean suspect,
      @Schema(
              description =
                  "JUDGED: there is a result of the case; ABSENT: no case of the build has these"
                      + " inputs, or the commit does not have the test model")
          CasePoint.State state,
      @Schema(description = "why there is no result of the case; absent if there is one")
          @Nullable String reason,
      @Schema(description = "number of the case in this build; absent without a result")
          @Nullable Integer no,
      @Nullable Verdict verdict,
      @Schema(description = "whether all inputs are valid; absent if it is not known")
          @Nullable Boolean valid,
      @Schema(
              description =
                  "outputs and observations by name, shortened to 200 characters; of a sequence"
                      + " with number and name of the step; at most 50")
          Map<String, String> actual,
      @Schema(description = "absent without conditions over time") @Nullable MarginView margin,
      @Schema(description = "absent if the call did not end") @Nullable TimeView time,
      @Schema(description = "why the verdict is not PASS, shortened to 1000 characters")
          @Nullable String message,
      @Schema(
              description =
                  "whether the verdict is another one than in the nearest earlier item with a"
                      + " result; absent without one, and for commits that were removed")
          @Nullable Boolean verdictChanged,
      @Schema(
              description =
                  "whether values, errors or calls differ from that item by more than the last"
                      + " bits; absent like verdictChanged")
          @Nullable Boolean valueChanged) {
    static PointView of(CaseHistories.Judged judged) {
      CasePoint point = judged.point();
      CasePoint.Subject commit = point.commit();
      CaseResult result = point.result();
      return new PointView(
          commit == null ? null : commit.sha(),
          commit == null ? null : nullIfEmpty(commit.subject()),
          commit == null ? null : nullIfEmpty(commit.author()),
          point.at(),
          point.replaced(),
          point.buildId(),
          point.takenFrom(),
          point.suspect(),
          point.state(),
          nullIfEmpty(point.reason()),
          result == null ? null : result.no(),
          result == null ? null : result.verdict(),
          judged.valid(),
          result == null ? Map.of() : actual(result),
          result == null ? null : MarginView.of(result),
          result == null ? null : TimeView.of(result),
          result == null ? null : nullIfEmpty(shortened(result.message(), MAX_TEXT)),
          judged.verdictChanged(),
          judged.valueChanged());
    }

    private static Map<String, String> actual(CaseResult result) {
      Map<String, String> actual = new LinkedHashMap<>();
      add(actual, "", result.actual());
      for (int i = 0; i < result.steps().size() && actual.size() < MAX_VALUES; i++) {
        StepResult step = result.steps().get(i);
        add(actual, (i + 1) + " " + step.name() + " ", step.actual());
      }
      return actual;
    }

    private static void add(Map<String, String> actual, String before, List<NamedValue> values) {
      values.stream()
          .limit(MAX_VALUES - actual.size())
          .forEach(
              value ->
                  actual.put(
                      before
                          + (value.output().isEmpty() ? OutputElement.RETURN_NAME : value.output()),
                      shortened(value.literal(), MAX_VALUE)));
    }
  }

  static CaseHistoryView of(CaseHistories.History history, int page, int size) {
    CaseResult testCase = history.testCase();
    return new CaseHistoryView(
        history.buildId(),
        testCase.no(),
        history.parameters().stream().map(CaseParameter::name).toList(),
        testCase.values().stream().map(value -> shortened(value, MAX_VALUE)).toList(),
        testCase.steps().size(),
        history.by(),
        history.points().stream().map(PointView::of).toList(),
        page,
        size,
        history.total());
  }

  private static String shortened(String text, int max) {
    return text.length() <= max ? text : text.substring(0, max) + "…";
  }

  private static @Nullable String nullIfEmpty(String text) {
    return text.isEmpty() ? null : text;
  }
}
