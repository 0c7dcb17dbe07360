package org.sitaf.server.build.recording;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.OutdatedAttemptException;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Recordings of the simulation. A build has the recordings of its latest attempt, or those of its
 * shards. Equal recordings share their content.
 */
@Component
public class Recordings {
  /** Maximum number of recordings per attempt. */
  public static final int MAX_RECORDINGS = 500;

  /** Maximum number of relations of a test model. */
  private static final int MAX_RELATIONS = 20;

  private static final int MAX_BYTES = 32 << 20;
  private static final int HEADER_BYTES = 12;
  private static final int MAGIC = 0x46546C67;
  private static final int VERSION = 2;

  private static final String IN_LATEST_ATTEMPT =
      " JOIN attempt a ON a.token = r.token JOIN build b ON b.id = a.build_id"
          + " AND b.attempt = a.no WHERE (b.id = :build OR b.parent_id = :build)";

  private static final String OF_LATEST_ATTEMPT = " FROM recording r" + IN_LATEST_ATTEMPT;

  private final Builds builds;
  private final StoredFiles contents;
  private final JdbcClient jdbc;
  private final TransactionTemplate transaction;
  private final long maxBytes;
  private final Clock clock;

  Recordings(
      Builds builds,
      StoredFiles contents,
      JdbcClient jdbc,
      TransactionTemplate transaction,
      SitafSettings settings,
      Clock clock) {
    this.builds = builds;
    this.contents = contents;
    this.jdbc = jdbc;
    this.transaction = transaction;
    this.maxBytes = settings.maxRecordings().toBytes();
    this.clock = clock;
  }

  /** The order of a list. */
  public enum Order {
    /** By the number of the case. */
    CASE,
    /** Newest first. */
    NEWEST
  }

  /**
   * Stores a recording of a case of a running attempt. Repeating the call changes nothing.
   *
   * @param relation index of the relation, from 1, if it is that of a second run; 0 for the case
   *     itself
   * @param sha256 hash from the agent, which is verified
   * @throws RequestException if the build is not recorded, or a limit is exceeded
   * @throws org.sitaf.server.build.OutdatedAttemptException if the attempt has ended
   */
  public void store(AttemptKey key, int caseNo, int relation, byte[] gltf, String sha256) {
    if (recordedCases(key) == RecordedCases.NONE) {
      throw RequestException.malformed("recordings: build " + key.buildId() + " is not recorded.");
    }
    if (caseNo < 1) {
      throw RequestException.malformed("case_no: must be 1 or more.");
    }
    if (relation < 0 || relation > MAX_RELATIONS) {
      throw RequestException.malformed("relation: must be 0 to " + MAX_RELATIONS + ".");
    }
    requireGlb(gltf);
    String actual = StoredFiles.sha256(gltf);
    if (!actual.equals(sha256)) {
      throw RequestException.malformed(
          "sha256: is " + sha256 + ", but the recording's is " + actual + ".");
    }
    requireWithinLimits(key, caseNo, relation, gltf.length);
    contents.store(gltf);
    transaction.executeWithoutResult(status -> insert(key, caseNo, relation, actual, gltf.length));
  }

  private RecordedCases recordedCases(AttemptKey key) {
    return jdbc.sql(
            "SELECT b.recorded_cases FROM attempt a JOIN build b ON b.id = a.build_id"
                + " WHERE a.token = ? AND a.build_id = ? AND a.no = ? AND a.finished IS NULL")
        .params(key.token(), key.buildId(), key.no())
        .query((row, index) -> RecordedCases.valueOf(row.getString(1)))
        .optional()
        .orElseThrow(() -> new OutdatedAttemptException(key, "has ended or does not exist"));
  }

  private static void requireGlb(byte[] gltf) {
    ByteBuffer header = ByteBuffer.wrap(gltf).order(ByteOrder.LITTLE_ENDIAN);
    if (gltf.length < HEADER_BYTES
        || gltf.length > MAX_BYTES
        || header.getInt() != MAGIC
        || header.getInt() != VERSION
        || header.getInt() != gltf.length) {
      throw RequestException.malformed("gltf: must be binary glTF 2.0 of at most 32 MiB.");
    }
  }

  /** The number of recordings is that of the recorded cases, with or without second runs. */
  private void requireWithinLimits(AttemptKey key, int caseNo, int relation, long size) {
    jdbc.sql(
            "SELECT COUNT(DISTINCT CASE WHEN case_no <> :case THEN case_no END),"
                + " COALESCE(SUM(CASE WHEN case_no <> :case OR relation <> :relation THEN size"
                + " ELSE 0 END), 0) FROM (SELECT case_no, 0 AS relation, size FROM recording"
                + " WHERE token = :token UNION ALL SELECT case_no, relation, size"
                + " FROM second_run_recording WHERE token = :token) recorded")
        .param("token", key.token())
        .param("case", caseNo)
        .param("relation", relation)
        .query(
            row -> {
              if (row.getLong(1) >= MAX_RECORDINGS || row.getLong(2) + size > maxBytes) {
                throw RequestException.tooLarge(
                    "An attempt can have at most %d recordings of %d MiB in total."
                        .formatted(MAX_RECORDINGS, maxBytes >> 20));
              }
            });
  }

  private void insert(AttemptKey key, int caseNo, int relation, String sha256, long size) {
    OffsetDateTime now = clock.instant().atOffset(ZoneOffset.UTC);
    if (relation > 0) {
      jdbc.sql("DELETE FROM second_run_recording WHERE token = ? AND case_no = ? AND relation = ?")
          .params(key.token(), caseNo, relation)
          .update();
      jdbc.sql(
              "INSERT INTO second_run_recording (token, case_no, relation, sha256, size, received)"
                  + " VALUES (?, ?, ?, ?, ?, ?)")
          .params(key.token(), caseNo, relation, sha256, size, now)
          .update();
      return;
    }
    int known =
        jdbc.sql("UPDATE recording SET sha256 = ?, size = ? WHERE token = ? AND case_no = ?")
            .params(sha256, size, key.token(), caseNo)
            .update();
    if (known == 0) {
      jdbc.sql(
              "INSERT INTO recording (token, case_no, sha256, size, received)"
                  + " VALUES (?, ?, ?, ?, ?)")
          .params(key.token(), caseNo, sha256, size, now)
          .update();
    }
  }

  /**
   * Returns a page of the recordings of a build.
   *
   * @throws RequestException if there is no such build
   */
  public Page<Recording> of(String buildId, Order order, Pageable page) {
    builds.inspect(buildId, build -> build.id());
    long total =
        jdbc.sql("SELECT COUNT(*)" + OF_LATEST_ATTEMPT)
            .param("build", buildId)
            .query(Long.class)
            .single();
    String by = order == Order.CASE ? "r.case_no" : "r.received DESC, r.case_no DESC";
    List<Recording> found =
        jdbc.sql(
                "SELECT r.case_no, r.sha256, r.size, r.received"
                    + OF_LATEST_ATTEMPT
                    + " ORDER BY "
                    + by
                    + " LIMIT :size OFFSET :offset")
            .param("build", buildId)
            .param("size", page.getPageSize())
            .param("offset", page.getOffset())
            .query((row, index) -> read(row))
            .list();
    return new PageImpl<>(found, page, total);
  }

  /**
   * Returns the recording of a case.
   *
   * @throws RequestException if there is none
   */
  public Recording find(String buildId, int caseNo) {
    Optional<Recording> found =
        jdbc.sql(
                "SELECT r.case_no, r.sha256, r.size, r.received"
                    + OF_LATEST_ATTEMPT
                    + " AND r.case_no = :case")
            .param("build", buildId)
            .param("case", caseNo)
            .query((row, index) -> read(row))
            .optional();
    return found.orElseThrow(
        () -> RequestException.notFound("recording in build " + buildId + " of case", caseNo + ""));
  }

  /**
   * Returns the recording of the second run of a case.
   *
   * @param relation index of the relation in the test model, from 1
   * @throws RequestException if there is none
   */
  public Recording findSecondRun(String buildId, int caseNo, int relation) {
    Optional<Recording> found =
        jdbc.sql(
                "SELECT r.case_no, r.sha256, r.size, r.received FROM second_run_recording r"
                    + IN_LATEST_ATTEMPT
                    + " AND r.case_no = :case AND r.relation = :relation")
            .param("build", buildId)
            .param("case", caseNo)
            .param("relation", relation)
            .query((row, index) -> read(row))
            .optional();
    return found.orElseThrow(
        () ->
            RequestException.notFound(
                "recording in build " + buildId + " of the second run of case",
                caseNo + ", relation " + relation));
  }

  /** Returns the binary glTF file. */
  public byte[] content(Recording recording) {
    return contents.content(recording.sha256());
  }

  private static Recording read(ResultSet row) throws SQLException {
    return new Recording(
        row.getInt(1),
        row.getString(2),
        row.getLong(3),
        row.getObject(4, OffsetDateTime.class).toInstant());
  }
}
