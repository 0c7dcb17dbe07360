package org.sitaf.server.build.log;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.context.event.EventListener;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/**
 * The logs of builds, which contain the logs of their attempts one after the other. They are stored
 * in chunks in the database. {@code build.log_length} is the number of bytes that agents sent;
 * bytes beyond the limit are not stored.
 */
@Component
public class BuildLogs {
  private static final byte[] TRUNCATED =
      "\n[log truncated: it exceeds the limit of this server]\n".getBytes(StandardCharsets.UTF_8);

  private static final int EXCERPT_BYTES = 1 << 20;

  /** Maximum size of a stored chunk, in bytes; readers use it to find the first chunk. */
  static final int MAX_CHUNK = 256 << 10;

  private final long limit;
  private final Attempts attempts;
  private final JdbcClient jdbc;

  BuildLogs(SitafSettings settings, Attempts attempts, JdbcClient jdbc) {
    this.limit = settings.maxLog().toBytes();
    this.attempts = attempts;
    this.jdbc = jdbc;
  }

  /** A chunk begins after the end of the log. */
  public static final class GapException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    GapException(long offset, long end) {
      super("offset " + offset + " is beyond the end of the attempt's log, " + end);
    }
  }

  /**
   * A part of a log.
   *
   * @param end current length of the log, in bytes
   */
  @SuppressWarnings("ArrayRecordComponent") // Never compared.
  public record Excerpt(byte[] bytes, long end) {}

  /**
   * Appends to the log of a running attempt; bytes that are stored already are skipped.
   *
   * @param offset of the chunk in the attempt's log, in bytes
   * @return the new length of the attempt's log
   * @throws GapException if the offset is beyond the end
   */
  @Transactional
  public long append(AttemptKey key, long offset, byte[] chunk) {
    long start = attempts.logStartOfRunning(key);
    long end = length(key.buildId(), " FOR UPDATE");
    long at = start + offset;
    if (offset < 0 || at > end) {
      throw new GapException(offset, end - start);
    }
    int known = (int) Math.min(end - at, chunk.length);
    if (known == chunk.length) {
      return end - start;
    }
    long newEnd = at + chunk.length;
    write(key.buildId(), end, chunk, known, chunk.length - known);
    jdbc.sql("UPDATE build SET log_length = ? WHERE id = ?").params(newEnd, key.buildId()).update();
    return newEnd - start;
  }

  /** The length of the log of a build's latest attempt, in bytes. */
  @Transactional(readOnly = true)
  public long size(AttemptKey key) {
    return Math.max(0, length(key.buildId(), "") - attempts.logStart(key));
  }

  /**
   * Reads a part of a log.
   *
   * @throws RequestException if there is no such build, or if the offset is beyond the end
   */
  @Transactional(readOnly = true)
  public Excerpt read(String buildId, long offset, int limit) {
    length(buildId, "");
    long end =
        jdbc.sql(
                "SELECT start_at + size FROM build_log WHERE build_id = ?"
                    + " ORDER BY start_at DESC LIMIT 1")
            .param(buildId)
            .query(Long.class)
            .optional()
            .orElse(0L);
    if (offset < 0 || offset > end) {
      throw RequestException.malformed(
          "offset must be between 0 and the end of the log, " + end + ".");
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    jdbc.sql(
            "SELECT start_at, bytes FROM build_log WHERE build_id = ? AND start_at > ?"
                + " AND start_at < ? ORDER BY start_at")
        .params(buildId, offset - MAX_CHUNK, offset + limit)
        .query(
            row -> {
              byte[] chunk = row.getBytes(2);
              long skipped = Math.max(0, offset - row.getLong(1));
              long length = Math.min(chunk.length - skipped, (long) limit - bytes.size());
              if (length > 0) {
                bytes.write(chunk, (int) skipped, (int) length);
              }
            });
    return new Excerpt(bytes.toByteArray(), end);
  }

  /**
   * Returns the log of a case.
   *
   * @throws RequestException if there is no such build
   */
  @Transactional(readOnly = true)
  public byte[] ofCase(String buildId, int no, int limit) {
    CaseLog reader = new CaseLog(no, limit);
    long offset = 0;
    Excerpt excerpt = read(buildId, offset, EXCERPT_BYTES);
    while (excerpt.bytes().length > 0 && reader.read(excerpt.bytes())) {
      offset += excerpt.bytes().length;
      excerpt = read(buildId, offset, EXCERPT_BYTES);
    }
    return reader.result();
  }

  /** Concatenates the logs of the shards. */
  @EventListener
  @Transactional(propagation = Propagation.MANDATORY)
  public void on(BuildEvent.ShardsEnded ended) {
    long at = 0;
    int no = 0;
    for (String shard : ended.shardIds()) {
      no++;
      String title = "== shard %d of %d\n".formatted(no, ended.shardIds().size());
      at = put(ended.buildId(), at, title.getBytes(StandardCharsets.UTF_8));
      Excerpt excerpt = read(shard, 0, EXCERPT_BYTES);
      for (long read = 0; excerpt.bytes().length > 0 && at <= limit; ) {
        at = put(ended.buildId(), at, excerpt.bytes());
        read += excerpt.bytes().length;
        excerpt = read(shard, read, EXCERPT_BYTES);
      }
    }
    jdbc.sql("UPDATE build SET log_length = ? WHERE id = ?").params(at, ended.buildId()).update();
  }

  private long put(String buildId, long at, byte[] bytes) {
    write(buildId, at, bytes, 0, bytes.length);
    return at + bytes.length;
  }

  private long length(String buildId, String lock) {
    return jdbc.sql("SELECT log_length FROM build WHERE id = ?" + lock)
        .param(buildId)
        .query(Long.class)
        .optional()
        .orElseThrow(() -> RequestException.notFound("build", buildId));
  }

  private void write(String buildId, long at, byte[] bytes, int from, int length) {
    if (at > limit) {
      return;
    }
    int kept = (int) Math.min(length, limit - at);
    for (int done = 0; done < kept; done += MAX_CHUNK) {
      int size = Math.min(MAX_CHUNK, kept - done);
      insert(buildId, at + done, Arrays.copyOfRange(bytes, from + done, from + done + size));
    }
    if (kept < length) {
      insert(buildId, limit, TRUNCATED);
    }
  }

  private void insert(String buildId, long at, byte[] chunk) {
    insert(jdbc, buildId, at, chunk);
  }

  static void insert(JdbcClient jdbc, String buildId, long at, byte[] chunk) {
    jdbc.sql("INSERT INTO build_log (build_id, start_at, size, bytes) VALUES (?, ?, ?, ?)")
        .params(buildId, at, chunk.length, chunk)
        .update();
  }
}
