package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.RelationResult;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;

/** A case of a result in the REST interface. */
@Schema(name = "ResultCase")
public record CaseView(
    @Schema(description = "from 1") int no,
    @Schema(description = "in the order of the result's parameters") List<String> values,
    @Schema(description = "by name of the output") Map<String, String> expected,
    @Schema(description = "by name of the output") Map<String, String> actual,
    Verdict verdict,
    @Schema(description = "the trajectory conditions, in the order of the model")
        List<TrajectoryView> trajectories,
    @Schema(description = "the relations between two runs, in the order of the model")
        List<RelationView> relations,
    @Schema(description = "time of the component in the judged call, in microseconds")
        @Nullable Double processingTimeUs,
    @Schema(description = "the repeated calls; absent if calls are not repeated")
        @Nullable RepeatedView repeated,
    @Schema(description = "time spent in virtual hardware, in microseconds")
        @Nullable Double hardwareUs,
    @Schema(description = "time spent in stubs, in microseconds") @Nullable Double stubUs,
    @Schema(description = "why the verdict is not PASS") @Nullable String message,
    @Schema(description = "the steps of a sequence, in their order; empty if the case is one call")
        List<StepView> steps,
    @Schema(description = "absent if all devices are simulated") @Nullable DevicesView devices) {
  public static CaseView of(CaseResult result) {
    CaseResult.ProcessingTime time = result.time();
    return new CaseView(
        result.no(),
        result.values(),
        byOutput(result.expected()),
        byOutput(result.actual()),
        result.verdict(),
        result.trajectories().stream().map(TrajectoryView::of).toList(),
        result.relations().stream().map(RelationView::of).toList(),
        time == null ? null : time.total(),
        result.repeated() == null ? null : RepeatedView.of(result.repeated()),
        time == null ? null : time.hardware(),
        time == null ? null : time.stub(),
        result.message().isEmpty() ? null : result.message(),
        result.steps().stream().map(StepView::of).toList(),
        result.hardware() == null ? null : DevicesView.of(result.hardware()));
  }

  /** What was measured of real and recorded devices, in the REST interface. */
  @Schema(name = "DevicesOfCase", description = "real and recorded devices in a case")
  public record DevicesView(
      @Schema(description = "names with what serves them, such as ir1: a real device")
          List<String> devices,
      @Schema(description = "mean time by which steps ended too late on the wall clock, in ms")
          double meanJitterMs,
      @Schema(description = "greatest time by which a step ended too late, in ms")
          double maxJitterMs,
      @Schema(description = "steps that ended later than the next one should have")
          long missedDeadlines,
      @Schema(description = "of real devices") long readings,
      @Schema(description = "greatest age of an accepted reading, in ms") double maxAgeMs,
      @Schema(description = "readings that were too old") long staleReadings,
      @Schema(description = "commands beyond an envelope") long refusedCommands,
      @Schema(description = "how often the devices were stopped") long safeStops,
      @Schema(description = "why devices did not work; empty if they did") List<String> faults) {
    private static final double MS_PER_S = 1e3;

    static DevicesView of(HardwareReport report) {
      return new DevicesView(
          report.devices(),
          report.meanJitter() * MS_PER_S,
          report.maxJitter() * MS_PER_S,
          report.missedDeadlines(),
          report.readings(),
          report.maxAge() * MS_PER_S,
          report.staleReadings(),
          report.refusedCommands(),
          report.safeStops(),
          report.faults());
    }
  }

  /** The result of a step of a sequence in the REST interface. */
  @Schema(name = "StepResult")
  public record StepView(
      @Schema(description = "the call or event of the test model") String name,
      @Schema(description = "FORBIDDEN: the guard is false; INVALID: a value is invalid")
          StepResult.Kind kind,
      Verdict verdict,
      @Schema(
              description =
                  "whether an earlier step of the case failed, so that this verdict may be a"
                      + " consequence")
          boolean afterFailure,
      @Schema(description = "by name of the input; empty for an event") Map<String, String> inputs,
      @Schema(description = "by name of the output") Map<String, String> expected,
      @Schema(description = "by name of the output") Map<String, String> actual,
      @Schema(
              description =
                  "simulation time in seconds since the first step began; absent if it was not"
                      + " executed")
          @Nullable Double at,
      @Schema(description = "time of the component in the call, in microseconds")
          @Nullable Double processingTimeUs,
      @Schema(description = "why the verdict is not PASS") @Nullable String message,
      @Schema(description = "the abstract state before the step; absent if it is unknown")
          @Nullable String before,
      @Schema(description = "the abstract state after the step; absent if it is unknown")
          @Nullable String after) {
    static StepView of(StepResult step) {
      return new StepView(
          step.name(),
          step.kind(),
          step.verdict(),
          step.afterFailure(),
          byName(step.inputs()),
          byOutput(step.expected()),
          byOutput(step.actual()),
          step.at(),
          step.time() == null ? null : step.time().total(),
          step.message().isEmpty() ? null : step.message(),
          step.before(),
          step.after());
    }
  }

  /** The result of a trajectory condition in the REST interface. */
  @Schema(name = "TrajectoryResult")
  public record TrajectoryView(
      String name,
      Verdict verdict,
      @Schema(description = "quantitative robustness: a number, Infinity or -Infinity")
          @Nullable String margin,
      @Schema(description = "seconds after the call: when the verdict was decided, else the end")
          @Nullable Double at) {
    static TrajectoryView of(TrajectoryResult result) {
      Double margin = result.margin();
      return new TrajectoryView(
          result.name(), result.verdict(), margin == null ? null : margin.toString(), result.at());
    }
  }

  /** The result of a relation between two runs in the REST interface. */
  @Schema(name = "RelationResult")
  public record RelationView(
      String name,
      RelationResult.Outcome verdict,
      @Schema(description = "inputs of the second run; empty if there was none")
          List<String> values,
      @Schema(description = "outputs of the second run, by name") Map<String, String> actual,
      @Schema(description = "why the verdict is not PASS") @Nullable String message) {
    static RelationView of(RelationResult result) {
      return new RelationView(
          result.name(),
          result.outcome(),
          result.values(),
          byOutput(result.actual()),
          result.message().isEmpty() ? null : result.message());
    }
  }

  /** The repeated calls of a case in the REST interface. */
  @Schema(name = "RepeatedCalls", description = "times of the component, in microseconds")
  public record RepeatedView(
      @Schema(description = "number of calls before the measured ones") int warmUp,
      @Schema(
              description =
                  "number of measured calls; fewer than ordered when half of limits.case_wall_s had"
                      + " passed")
          int calls,
      @Schema(description = "absent without calls") @Nullable Double medianUs,
      @Schema(description = "lower end of the 95 % interval of the median; absent below 6 calls")
          @Nullable Double lowUs,
      @Schema(description = "upper end of the 95 % interval of the median; absent below 6 calls")
          @Nullable Double highUs,
      @Schema(description = "how a repeated call differs from the judged one; absent if none does")
          @Nullable String differs) {
    static RepeatedView of(RepeatedCalls calls) {
      return new RepeatedView(
          calls.warmUp(),
          calls.calls(),
          calls.median(),
          calls.low(),
          calls.high(),
          calls.differ() ? calls.differs() : null);
    }
  }

  private static Map<String, String> byName(List<NamedValue> values) {
    Map<String, String> byName = new LinkedHashMap<>();
    values.forEach(v -> byName.put(v.output(), v.literal()));
    return byName;
  }

  private static Map<String, String> byOutput(List<NamedValue> values) {
    Map<String, String> byName = new LinkedHashMap<>();
    values.forEach(
        v ->
            byName.put(v.output().isEmpty() ? OutputElement.RETURN_NAME : v.output(), v.literal()));
    return byName;
  }
}
