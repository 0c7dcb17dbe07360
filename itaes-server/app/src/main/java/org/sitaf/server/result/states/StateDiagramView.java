package org.sitaf.server.result.states;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.StateDiagram;
import org.sitaf.core.verdict.StepResult;

/** The diagram of abstract states in the REST interface. */
@Schema(
    name = "StateDiagram",
    description =
        "what the cases executed, and what the model allows with the same values; empty if the"
            + " cases are no sequences. In a preview nothing has been executed")
public record StateDiagramView(
    @Schema(description = "the initial one first") List<StateView> states,
    @Schema(description = "those that failed first, those that were not executed last")
        List<TransitionView> transitions,
    @Schema(description = "false if the model has more states than the diagram") boolean complete,
    @Schema(description = "simulation time in seconds that passes before the first step")
        double settleS) {
  static final StateDiagramView NONE = new StateDiagramView(List.of(), List.of(), true, 0);

  @Schema(name = "DiagramState")
  public record StateView(
      @Schema(description = "values of the state variables") String name,
      @Schema(description = "number of executed steps that began in it") int steps) {}

  @Schema(name = "DiagramTransition")
  public record TransitionView(
      @Schema(description = "index of the state before the step") int from,
      @Schema(description = "index of the state after the step") int to,
      @Schema(description = "name of the step") String step,
      StepResult.Kind kind,
      int passed,
      @Schema(description = "how many executions decided the verdict of their case") int failed,
      @Schema(description = "number of the first case in which it failed")
          @Nullable Integer failedCase) {}

  /**
   * The view of a diagram.
   *
   * @param settle simulation time before the first step
   */
  public static StateDiagramView of(StateDiagram diagram, Duration settle) {
    return new StateDiagramView(
        diagram.states().stream().map(s -> new StateView(s.name(), s.steps())).toList(),
        diagram.transitions().stream()
            .map(
                t ->
                    new TransitionView(
                        t.from(),
                        t.to(),
                        t.step(),
                        t.kind(),
                        t.passed(),
                        t.failed(),
                        t.failedCase()))
            .toList(),
        diagram.isComplete(),
        settle.toNanos() / 1e9);
  }
}
