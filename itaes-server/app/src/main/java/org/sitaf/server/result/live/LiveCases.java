package org.sitaf.server.result.live;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;
import tools.jackson.core.type.TypeReference;
import tools.jackson.databind.json.JsonMapper;

/**
 * Finished cases of running builds, in the order in which agents report them. They are deleted when
 * the result is accepted; builds that were cancelled or failed keep them.
 */
@Repository
public class LiveCases {
  private static final TypeReference<List<CaseResult>> CASES = new TypeReference<>() {};

  /** Cases of a build and of its shards. */
  private static final String OF_BUILD =
      " WHERE (build_id = :build OR build_id IN (SELECT id FROM build WHERE parent_id = :build))";

  private final JdbcClient jdbc;
  private final JsonMapper json;

  LiveCases(JdbcClient jdbc, JsonMapper json) {
    this.jdbc = jdbc;
    this.json = json;
  }

  /** Appends finished cases, within the transaction that counts them. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void append(String buildId, List<CaseResult> finished) {
    if (!finished.isEmpty()) {
      jdbc.sql("INSERT INTO live_cases (build_id, cases, outcomes) VALUES (?, ?, ?)")
          .params(buildId, finished.size(), json.writeValueAsBytes(finished))
          .update();
    }
  }

  /** Deletes all cases of a build. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void delete(String buildId) {
    jdbc.sql("DELETE FROM live_cases" + OF_BUILD).param("build", buildId).update();
  }

  private record Batch(long id, int cases) {}

  /**
   * Returns a page of the cases in the order in which they finished.
   *
   * @throws RequestException if there is no such build
   */
  @Transactional(readOnly = true)
  public Page<CaseResult> page(String buildId, Pageable page) {
    requireBuild(buildId);
    List<Batch> batches =
        jdbc.sql("SELECT id, cases FROM live_cases" + OF_BUILD + " ORDER BY id")
            .param("build", buildId)
            .query((row, index) -> new Batch(row.getLong(1), row.getInt(2)))
            .list();
    long from = page.getOffset();
    long to = from + page.getPageSize();
    long at = 0;
    List<CaseResult> items = new ArrayList<>();
    for (Batch batch : batches) {
      long end = at + batch.cases();
      if (end > from && at < to) {
        List<CaseResult> cases = cases(batch.id());
        int first = (int) Math.max(0, from - at);
        int last = (int) Math.min(cases.size(), to - at);
        items.addAll(cases.subList(Math.min(first, last), last));
      }
      at = end;
    }
    return new PageImpl<>(items, page, at);
  }

  private List<CaseResult> cases(long batch) {
    byte[] outcomes =
        jdbc.sql("SELECT outcomes FROM live_cases WHERE id = ?")
            .param(batch)
            .query((row, index) -> row.getBytes(1))
            .single();
    return json.readValue(outcomes, CASES);
  }

  private void requireBuild(String buildId) {
    boolean exists =
        jdbc.sql("SELECT 1 FROM build WHERE id = ?")
            .param(buildId)
            .query(Integer.class)
            .optional()
            .isPresent();
    if (!exists) {
      throw RequestException.notFound("build", buildId);
    }
  }
}
