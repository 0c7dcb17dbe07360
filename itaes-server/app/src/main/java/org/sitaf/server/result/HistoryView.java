package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Summary;
import org.sitaf.server.result.ResultView.SummaryView;

/** The result of a build among those before and after it. */
@Schema(name = "ResultOfBuild")
record HistoryView(
    String buildId,
    String model,
    Instant received,
    @Nullable String agent,
    SummaryView summary,
    @Schema(description = "whether the verdicts are not to be trusted") boolean suspect) {
  static HistoryView of(Row row) {
    return new HistoryView(
        row.buildId(),
        row.model(),
        row.received(),
        row.agent(),
        SummaryView.of(row.summary()),
        row.suspect());
  }

  /** As the database has it. */
  record Row(
      String buildId,
      String model,
      Instant received,
      @Nullable String agent,
      Summary summary,
      boolean suspect) {}
}
