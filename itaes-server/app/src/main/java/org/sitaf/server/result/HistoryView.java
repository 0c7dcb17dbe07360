package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Summary;
import org.sitaf.server.result.ResultView.SummaryView;

/** A result in the history of an activity. */
@Schema(name = "ResultOfBuild")
record HistoryView(
    String buildId,
    String model,
    Instant received,
    @Nullable String agent,
    SummaryView summary,
    @Schema(description = "whether the verdicts cannot be trusted") boolean suspect,
    @Schema(description = "id of the tested commit; absent if it is not known")
        @Nullable String commit) {
  static HistoryView of(Row row) {
    return new HistoryView(
        row.buildId(),
        row.model(),
        row.received(),
        row.agent(),
        SummaryView.of(row.summary()),
        row.suspect(),
        row.commit());
  }

  /** A row of the database. */
  record Row(
      String buildId,
      String model,
      Instant received,
      @Nullable String agent,
      Summary summary,
      boolean suspect,
      @Nullable String commit) {}
}
