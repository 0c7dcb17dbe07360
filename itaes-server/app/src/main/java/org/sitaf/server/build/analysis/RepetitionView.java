package org.sitaf.server.build.analysis;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.sitaf.core.flaky.FlakyCause;
import org.sitaf.core.verdict.Verdict;

/** What repeated runs of the cases showed, in the REST interface and in the database. */
@Schema(name = "Repetition")
public record RepetitionView(
    @Schema(description = "number of further runs") int runs,
    @Schema(description = "number of cases whose verdicts or values differ between the runs")
        int count,
    @Schema(description = "these cases, at most 1,000") List<FlakyCaseView> cases) {
  /** A case that is not reproducible. */
  @Schema(name = "FlakyCase")
  public record FlakyCaseView(
      int no,
      @Schema(
              description =
                  "what makes the runs differ; MACHINE: only times, which exceed a limit; UNKNOWN:"
                      + " only the build differs from all further runs")
          FlakyCause cause,
      @Schema(description = "first that of the build, then those of the further runs")
          List<Verdict> verdicts,
      @Schema(description = "where the runs diverge") String reason) {}
}
