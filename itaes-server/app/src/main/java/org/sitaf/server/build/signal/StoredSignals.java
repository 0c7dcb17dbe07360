package org.sitaf.server.build.signal;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.OutdatedAttemptException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.support.TransactionTemplate;
import tools.jackson.databind.json.JsonMapper;

/**
 * Signals of cases. A build has the signals of its latest attempt, or those of its shards. They are
 * deleted with the build.
 */
@Component
public class StoredSignals {
  /** Maximum number of cases with signals per attempt. */
  public static final int MAX_CASES = 500;

  private final Builds builds;
  private final StoredFiles contents;
  private final JdbcClient jdbc;
  private final TransactionTemplate transaction;
  private final JsonMapper json;
  private final long maxBytes;

  StoredSignals(
      Builds builds,
      StoredFiles contents,
      JdbcClient jdbc,
      TransactionTemplate transaction,
      JsonMapper json,
      SitafSettings settings) {
    this.builds = builds;
    this.contents = contents;
    this.jdbc = jdbc;
    this.transaction = transaction;
    this.json = json;
    this.maxBytes = settings.maxSignals().toBytes();
  }

  record Found(String sha256) {}

  /**
   * Stores the signals of a case of a running attempt. Repeating the call changes nothing.
   *
   * @param signals untrusted
   * @throws RequestException if the signals are not valid, or a limit is exceeded
   * @throws OutdatedAttemptException if the attempt has ended
   */
  public void store(AttemptKey key, int caseNo, CaseSignals signals) {
    requireRunning(key);
    if (caseNo < 1) {
      throw RequestException.malformed("case_no: must be 1 or more.");
    }
    signals.check();
    byte[] content = compressed(signals);
    requireWithinLimits(key, caseNo, content.length);
    String sha256 = contents.store(content);
    transaction.executeWithoutResult(status -> insert(key, caseNo, sha256, content.length));
  }

  private void requireRunning(AttemptKey key) {
    boolean isRunning =
        jdbc.sql(
                "SELECT 1 FROM attempt WHERE token = ? AND build_id = ? AND no = ?"
                    + " AND finished IS NULL")
            .params(key.token(), key.buildId(), key.no())
            .query(Integer.class)
            .optional()
            .isPresent();
    if (!isRunning) {
      throw new OutdatedAttemptException(key, "has ended or does not exist");
    }
  }

  private byte[] compressed(CaseSignals signals) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(bytes)) {
      json.writeValue(out, signals);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private void requireWithinLimits(AttemptKey key, int caseNo, long size) {
    jdbc.sql(
            "SELECT COUNT(*), COALESCE(SUM(size), 0) FROM case_signals"
                + " WHERE token = ? AND case_no <> ?")
        .params(key.token(), caseNo)
        .query(
            row -> {
              if (row.getLong(1) >= MAX_CASES || row.getLong(2) + size > maxBytes) {
                throw RequestException.tooLarge(
                    "An attempt can have the signals of at most %d cases, of %d MiB in total."
                        .formatted(MAX_CASES, maxBytes >> 20));
              }
            });
  }

  private void insert(AttemptKey key, int caseNo, String sha256, long size) {
    int known =
        jdbc.sql("UPDATE case_signals SET sha256 = ?, size = ? WHERE token = ? AND case_no = ?")
            .params(sha256, size, key.token(), caseNo)
            .update();
    if (known == 0) {
      jdbc.sql("INSERT INTO case_signals (token, case_no, sha256, size) VALUES (?, ?, ?, ?)")
          .params(key.token(), caseNo, sha256, size)
          .update();
    }
  }

  /**
   * Finds the signals of a case.
   *
   * @throws RequestException if there is no such build
   */
  Optional<Found> find(String buildId, int caseNo) {
    builds.inspect(buildId, build -> build.id());
    return jdbc.sql(
            "SELECT s.sha256 FROM case_signals s JOIN attempt a ON a.token = s.token"
                + " JOIN build b ON b.id = a.build_id AND b.attempt = a.no"
                + " WHERE (b.id = :build OR b.parent_id = :build) AND s.case_no = :case")
        .param("build", buildId)
        .param("case", caseNo)
        .query((row, index) -> new Found(row.getString(1)))
        .optional();
  }

  /** SHA-256 of the signals of a build by the number of the case. */
  public Map<Integer, String> ofBuild(String buildId) {
    Map<Integer, String> found = new HashMap<>();
    jdbc.sql(
            "SELECT s.case_no, s.sha256 FROM case_signals s JOIN attempt a ON a.token = s.token"
                + " JOIN build b ON b.id = a.build_id AND b.attempt = a.no"
                + " WHERE b.id = :build OR b.parent_id = :build")
        .param("build", buildId)
        .query(
            row -> {
              found.put(row.getInt(1), row.getString(2));
            });
    return found;
  }

  /** The stored signals with this SHA-256. */
  public CaseSignals content(String sha256) {
    byte[] content = contents.content(sha256);
    try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(content))) {
      return json.readValue(in, CaseSignals.class);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
