package org.sitaf.server.result;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.result.CaseIdentity;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.jdbc.core.JdbcTemplate;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import tools.jackson.databind.json.JsonMapper;

/**
 * Stores accepted results. They are inserted in batches and never changed, so plain SQL is used.
 */
@Repository
class ResultRows {
  private static final int BATCH_SIZE = 500;

  /**
   * The databases limit a row to about a million characters; the document contains the full text.
   */
  private static final int MAX_OUTCOME = 500_000;

  private static final int MAX_TEXT = 1000;

  private static final int MAX_OF_STEP = 10;
  private static final int MAX_TEXT_OF_STEP = 200;

  private final JdbcClient jdbc;
  private final JdbcTemplate batches;
  private final JsonMapper json;

  ResultRows(JdbcClient jdbc, JdbcTemplate batches, JsonMapper json) {
    this.jdbc = jdbc;
    this.batches = batches;
    this.json = json;
  }

  void insert(String buildId, TestResult result, byte[] document, String sha256, Instant received) {
    jdbc.sql(
            "INSERT INTO result (build_id, sha256, received, document, overview)"
                + " VALUES (?, ?, ?, ?, ?)")
        .params(
            buildId,
            sha256,
            received.atOffset(ZoneOffset.UTC),
            document,
            json.writeValueAsString(Overview.of(result)))
        .update();
    Iterator<String> fingerprints = CaseIdentity.fingerprints(result).iterator();
    batches.batchUpdate(
        "INSERT INTO result_case (build_id, no, verdict, processing_time_us, outcome, fingerprint)"
            + " VALUES (?, ?, ?, ?, ?, ?)",
        result.cases(),
        BATCH_SIZE,
        (row, outcome) -> {
          row.setString(1, buildId);
          row.setInt(2, outcome.no());
          row.setString(3, outcome.verdict().name());
          row.setObject(
              4,
              outcome.micros().isEmpty() ? null : outcome.micros().getAsDouble(),
              java.sql.Types.DOUBLE);
          row.setString(5, toText(outcome));
          row.setString(6, fingerprints.next());
        });
  }

  void insertSuperseded(long token, byte[] document, Instant received) {
    jdbc.sql("INSERT INTO superseded_result (token, received, document) VALUES (?, ?, ?)")
        .params(token, received.atOffset(ZoneOffset.UTC), document)
        .update();
  }

  Optional<Overview> overview(String buildId) {
    return jdbc.sql("SELECT overview FROM result WHERE build_id = ?")
        .param(buildId)
        .query(String.class)
        .optional()
        .map(text -> json.readValue(text, Overview.class));
  }

  Optional<String> sha256(String buildId) {
    return jdbc.sql("SELECT sha256 FROM result WHERE build_id = ?")
        .param(buildId)
        .query(String.class)
        .optional();
  }

  Optional<byte[]> document(String buildId) {
    return jdbc.sql("SELECT document FROM result WHERE build_id = ?")
        .param(buildId)
        .query((row, index) -> row.getBytes(1))
        .optional();
  }

  Optional<String> activityName(String buildId) {
    return jdbc.sql("SELECT activity_name FROM build WHERE id = ?")
        .param(buildId)
        .query(String.class)
        .optional();
  }

  /** Cases by number; a verdict of null means all. */
  Page<CaseResult> cases(String buildId, @Nullable Verdict verdict, Pageable page) {
    String where =
        " FROM result_case WHERE build_id = :build"
            + (verdict == null ? "" : " AND verdict = :verdict");
    String verdictName = verdict == null ? "" : verdict.name();
    long total =
        jdbc.sql("SELECT COUNT(*)" + where)
            .param("build", buildId)
            .param("verdict", verdictName)
            .query(Long.class)
            .single();
    List<CaseResult> items =
        jdbc.sql("SELECT outcome" + where + " ORDER BY no LIMIT :size OFFSET :offset")
            .param("build", buildId)
            .param("verdict", verdictName)
            .param("size", page.getPageSize())
            .param("offset", page.getOffset())
            .query((row, index) -> json.readValue(row.getString(1), CaseResult.class))
            .list();
    return new PageImpl<>(items, page, total);
  }

  /** Results of an activity, newest first; a model of null means all. */
  Page<HistoryView.Row> history(String activityId, @Nullable String model, Pageable page) {
    String from =
        " FROM result r JOIN build b ON b.id = r.build_id WHERE b.activity_id = :activity"
            + (model == null ? "" : " AND b.model = :model");
    String modelName = model == null ? "" : model;
    long total =
        jdbc.sql("SELECT COUNT(*)" + from)
            .param("activity", activityId)
            .param("model", modelName)
            .query(Long.class)
            .single();
    List<HistoryView.Row> items =
        jdbc.sql(
                "SELECT b.id, b.model, b.agent, r.received, r.overview, b.suspicions, b.commit_id"
                    + from
                    + " ORDER BY r.received DESC, b.id LIMIT :size OFFSET :offset")
            .param("activity", activityId)
            .param("model", modelName)
            .param("size", page.getPageSize())
            .param("offset", page.getOffset())
            .query(
                (row, index) ->
                    new HistoryView.Row(
                        row.getString(1),
                        row.getString(2),
                        row.getObject(4, java.time.OffsetDateTime.class).toInstant(),
                        row.getString(3),
                        json.readValue(row.getString(5), Overview.class).summary(),
                        row.getString(6) != null,
                        row.getString(7)))
            .list();
    return new PageImpl<>(items, page, total);
  }

  private static final String EARLIER =
      "SELECT b.id, r.received, b.commit_id, b.fail, b.error FROM build b"
          + " JOIN result r ON r.build_id = b.id";

  /** A result as a row of the history of its model. */
  Optional<FailuresView.Earlier> asEarlier(String buildId) {
    return jdbc.sql(EARLIER + " WHERE b.id = ?")
        .param(buildId)
        .query((row, index) -> earlier(row))
        .optional();
  }

  /**
   * The results of the same activity and model whose builds were requested before, newest first.
   * Builds of some cases and suspect results are left out.
   */
  List<FailuresView.Earlier> earlier(String buildId, int max) {
    return jdbc.sql(
            EARLIER
                + " JOIN build self ON self.id = ? AND b.activity_id = self.activity_id"
                + " AND b.model = self.model AND b.created < self.created"
                + " WHERE b.case_numbers IS NULL AND b.parent_id IS NULL AND b.suspicions IS NULL"
                + " ORDER BY b.created DESC, b.id LIMIT ?")
        .params(buildId, max)
        .query((row, index) -> earlier(row))
        .list();
  }

  private static FailuresView.Earlier earlier(ResultSet row) throws SQLException {
    return new FailuresView.Earlier(
        row.getString(1),
        row.getObject(2, java.time.OffsetDateTime.class).toInstant(),
        row.getString(3),
        row.getInt(4) + row.getInt(5) > 0);
  }

  private String toText(CaseResult outcome) {
    String text = json.writeValueAsString(outcome);
    return text.length() <= MAX_OUTCOME ? text : json.writeValueAsString(shortened(outcome));
  }

  private static CaseResult shortened(CaseResult outcome) {
    CaseResult shortened =
        new CaseResult(
            outcome.no(),
            outcome.verdict(),
            outcome.values().stream().limit(MAX_TEXT / 10).map(ResultRows::cut).toList(),
            outcome.expected().stream().limit(MAX_TEXT / 10).map(ResultRows::cut).toList(),
            outcome.actual().stream().limit(MAX_TEXT / 10).map(ResultRows::cut).toList(),
            new StubCalls(List.of(), outcome.calls().recorded().size() + outcome.calls().leftOut()),
            outcome.time(),
            cut(outcome.message()));
    shortened = shortened.withSteps(outcome.steps().stream().map(ResultRows::shortened).toList());
    RepeatedCalls repeated = outcome.repeated();
    return repeated == null ? shortened : shortened.with(repeated);
  }

  /** A case has at most 200 steps, so that each may have a two-hundredth of the maximum. */
  private static StepResult shortened(StepResult step) {
    return new StepResult(
        step.name(),
        step.kind(),
        step.verdict(),
        step.afterFailure(),
        step.inputs().stream().limit(MAX_OF_STEP).map(ResultRows::cutShort).toList(),
        step.expected().stream().limit(MAX_OF_STEP).map(ResultRows::cutShort).toList(),
        step.actual().stream().limit(MAX_OF_STEP).map(ResultRows::cutShort).toList(),
        step.at(),
        step.time(),
        cut(step.message(), MAX_TEXT_OF_STEP),
        step.before() == null ? null : cut(step.before(), MAX_TEXT_OF_STEP),
        step.after() == null ? null : cut(step.after(), MAX_TEXT_OF_STEP));
  }

  private static NamedValue cutShort(NamedValue value) {
    return new NamedValue(value.output(), cut(value.literal(), MAX_TEXT_OF_STEP / 4));
  }

  private static NamedValue cut(NamedValue value) {
    return new NamedValue(value.output(), cut(value.literal()));
  }

  private static String cut(String text) {
    return cut(text, MAX_TEXT);
  }

  private static String cut(String text, int max) {
    return text.length() <= max ? text : text.substring(0, max) + "…";
  }
}
