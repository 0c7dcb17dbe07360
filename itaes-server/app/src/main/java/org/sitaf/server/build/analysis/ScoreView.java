package org.sitaf.server.build.analysis;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** How many injected faults a specification notices, in the REST interface and in the database. */
@Schema(name = "Score")
public record ScoreView(
    @Schema(description = "number of faults between test driver and component") int injected,
    int noticed,
    @Schema(description = "faults that change no recorded value") int equivalent,
    @Schema(description = "the other faults, at most 1,000") List<SurvivorView> survivors,
    List<OutputView> outputs,
    @Schema(description = "weaknesses of the specification as a whole") List<String> warnings,
    @Schema(description = "absent if the component has no sources")
        @Nullable MutationScoreView mutations) {
  /** How many mutations of the component's sources a specification notices. */
  @Schema(name = "MutationScore")
  public record MutationScoreView(
      @Schema(description = "number of mutations that were executed") int made,
      int noticed,
      @Schema(description = "mutations that change a recorded value which nothing looks at")
          List<SurvivorView> survivors,
      @Schema(
              description =
                  "mutations that change no recorded value, such as"
                      + " component/Arm.java:12: < replaced by <=")
          List<String> unchanged) {}

  /** A fault with an effect that no case notices. */
  @Schema(name = "SurvivingFault")
  public record SurvivorView(
      String fault,
      @Schema(description = "the output, input or required method") String where,
      @Schema(description = "what to add to the specification") String suggestion) {}

  /** The faults that change an output. */
  @Schema(name = "ScoredOutput")
  public record OutputView(String output, int changed, int noticed) {}
}
