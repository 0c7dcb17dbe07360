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
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * What moved in the cases of builds. Those of an attempt that was given up stay with it: a build
 * shows the recordings of its latest attempt, and one that was spread over parts those of its
 * parts. Builds in which the same things moved share the contents.
 */
@Component
public class Recordings {
  /** Of one attempt. */
  public static final int MAX_RECORDINGS = 500;

  private static final int MAX_BYTES = 32 << 20;
  private static final int HEADER_BYTES = 12;
  private static final int MAGIC = 0x46546C67;
  private static final int VERSION = 2;

  private static final String SHOWN =
      " FROM recording r JOIN attempt a ON a.token = r.token JOIN build b ON b.id = a.build_id"
          + " AND b.attempt = a.no WHERE (b.id = :build OR b.parent_id = :build)";

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

  /** In which order recordings are listed. */
  public enum Order {
    /** By number of the case. */
    CASE,
    /** The one that came last first. */
    NEWEST
  }

  /**
   * Stores what moved in a case of a live attempt; storing it again changes nothing.
   *
   * @param sha256 what the agent says
   * @throws Refusal when the build wants no such recording, or no more
   * @throws org.sitaf.server.build.OutdatedAttemptException when the attempt is over
   */
  public void store(AttemptKey key, int caseNo, byte[] gltf, String sha256) {
    RecordedCases wanted = wanted(key);
    if (wanted == RecordedCases.NONE) {
      throw Refusal.malformed("recordings: build " + key.buildId() + " asks for none.");
    }
    if (caseNo < 1) {
      throw Refusal.malformed("case_no: must be 1 or more.");
    }
    requireGlb(gltf);
    String actual = StoredFiles.sha256(gltf);
    if (!actual.equals(sha256)) {
      throw Refusal.malformed("sha256: is " + sha256 + ", the recording's is " + actual + ".");
    }
    requireRoom(key, caseNo, gltf.length);
    contents.store(gltf);
    transaction.executeWithoutResult(status -> refer(key, caseNo, actual, gltf.length));
  }

  private RecordedCases wanted(AttemptKey key) {
    return jdbc.sql(
            "SELECT b.recorded_cases FROM attempt a JOIN build b ON b.id = a.build_id"
                + " WHERE a.token = ? AND a.build_id = ? AND a.no = ? AND a.finished IS NULL")
        .params(key.token(), key.buildId(), key.no())
        .query((row, index) -> RecordedCases.valueOf(row.getString(1)))
        .optional()
        .orElseThrow(() -> new OutdatedAttemptException(key, "is over, or another one"));
  }

  private static void requireGlb(byte[] gltf) {
    ByteBuffer header = ByteBuffer.wrap(gltf).order(ByteOrder.LITTLE_ENDIAN);
    if (gltf.length < HEADER_BYTES
        || gltf.length > MAX_BYTES
        || header.getInt() != MAGIC
        || header.getInt() != VERSION
        || header.getInt() != gltf.length) {
      throw Refusal.malformed("gltf: must be binary glTF 2.0 of at most 32 MiB.");
    }
  }

  private void requireRoom(AttemptKey key, int caseNo, long size) {
    jdbc.sql(
            "SELECT COUNT(*), COALESCE(SUM(size), 0) FROM recording"
                + " WHERE token = ? AND case_no <> ?")
        .params(key.token(), caseNo)
        .query(
            row -> {
              if (row.getLong(1) >= MAX_RECORDINGS || row.getLong(2) + size > maxBytes) {
                throw Refusal.tooLarge(
                    "An attempt has at most %d recordings and %d MiB of them."
                        .formatted(MAX_RECORDINGS, maxBytes >> 20));
              }
            });
  }

  private void refer(AttemptKey key, int caseNo, String sha256, long size) {
    OffsetDateTime now = clock.instant().atOffset(ZoneOffset.UTC);
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
   * A page of the recordings of a build.
   *
   * @throws Refusal when there is no such build
   */
  public Page<Recording> of(String buildId, Order order, Pageable page) {
    builds.inspect(buildId, build -> build.id());
    long total =
        jdbc.sql("SELECT COUNT(*)" + SHOWN).param("build", buildId).query(Long.class).single();
    String by = order == Order.CASE ? "r.case_no" : "r.received DESC, r.case_no DESC";
    List<Recording> found =
        jdbc.sql(
                "SELECT r.case_no, r.sha256, r.size, r.received"
                    + SHOWN
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
   * The recording of a case.
   *
   * @throws Refusal when there is none
   */
  public Recording find(String buildId, int caseNo) {
    Optional<Recording> found =
        jdbc.sql(
                "SELECT r.case_no, r.sha256, r.size, r.received" + SHOWN + " AND r.case_no = :case")
            .param("build", buildId)
            .param("case", caseNo)
            .query((row, index) -> read(row))
            .optional();
    return found.orElseThrow(
        () -> Refusal.notFound("recording in build " + buildId + " of case", caseNo + ""));
  }

  /** Binary glTF. */
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
