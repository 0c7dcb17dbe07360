package org.sitaf.server.build.log;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.context.event.EventListener;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/**
 * The logs of builds, attempt after attempt, in chunks in the database: several servers share
 * nothing but that. {@code build.log_length} counts what agents have sent, which is more than is
 * stored where a log is larger than the limit.
 */
@Component
public class BuildLogs {
  private static final byte[] CUT =
      "\n[the log is cut here: it is larger than this server keeps]\n"
          .getBytes(StandardCharsets.UTF_8);

  private static final int READ_AT_ONCE = 1 << 20;

  /** Of a stored chunk, in bytes; a reader finds the first chunk by it. */
  static final int MAX_CHUNK = 256 << 10;

  private final long limit;
  private final Attempts attempts;
  private final JdbcClient jdbc;

  BuildLogs(SitafSettings settings, Attempts attempts, JdbcClient jdbc) {
    this.limit = settings.maxLog().toBytes();
    this.attempts = attempts;
    this.jdbc = jdbc;
  }

  /** The chunk begins beyond the end of what is there. */
  public static final class GapException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    GapException(long offset, long end) {
      super("offset " + offset + " lies beyond the end of the attempt's log, which is at " + end);
    }
  }

  /**
   * Part of a log.
   *
   * @param end where the log ends at present, in bytes
   */
  @SuppressWarnings("ArrayRecordComponent") // Handed on once, never compared.
  public record Excerpt(byte[] bytes, long end) {}

  /**
   * Appends to the log of a live attempt; what is there already is left out.
   *
   * @param offset where the chunk begins in the attempt's log, in bytes
   * @return where the attempt's log ends now
   * @throws GapException when the offset lies beyond the end
   */
  @Transactional
  public long append(AttemptKey key, long offset, byte[] chunk) {
    long start = attempts.logStart(key);
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

  /** How much of the log came of an attempt, the latest of its build, in bytes. */
  @Transactional(readOnly = true)
  public long size(AttemptKey key) {
    return Math.max(0, length(key.buildId(), "") - attempts.logBegin(key));
  }

  /**
   * Reads at most so many bytes.
   *
   * @throws Refusal when there is no such build, or its log ends before the offset
   */
  @Transactional(readOnly = true)
  public Excerpt read(String buildId, long offset, int atMost) {
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
      throw Refusal.malformed("offset must be between 0 and the end of the log, " + end + ".");
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    jdbc.sql(
            "SELECT start_at, bytes FROM build_log WHERE build_id = ? AND start_at > ?"
                + " AND start_at < ? ORDER BY start_at")
        .params(buildId, offset - MAX_CHUNK, offset + atMost)
        .query(
            row -> {
              byte[] chunk = row.getBytes(2);
              long skipped = Math.max(0, offset - row.getLong(1));
              long length = Math.min(chunk.length - skipped, (long) atMost - bytes.size());
              if (length > 0) {
                bytes.write(chunk, (int) skipped, (int) length);
              }
            });
    return new Excerpt(bytes.toByteArray(), end);
  }

  /**
   * What a log holds of one case, at most so many bytes of it.
   *
   * @throws Refusal when there is no such build
   */
  @Transactional(readOnly = true)
  public byte[] ofCase(String buildId, int no, int atMost) {
    CaseLog reader = new CaseLog(no, atMost);
    long offset = 0;
    Excerpt excerpt = read(buildId, offset, READ_AT_ONCE);
    while (excerpt.bytes().length > 0 && reader.read(excerpt.bytes())) {
      offset += excerpt.bytes().length;
      excerpt = read(buildId, offset, READ_AT_ONCE);
    }
    return reader.found();
  }

  /** The log of a build that was spread over parts is theirs, one after the other. */
  @EventListener
  @Transactional(propagation = Propagation.MANDATORY)
  public void on(BuildEvent.PartsEnded ended) {
    long at = 0;
    int no = 0;
    for (String part : ended.partIds()) {
      no++;
      String title = "== shard %d of %d\n".formatted(no, ended.partIds().size());
      at = put(ended.buildId(), at, title.getBytes(StandardCharsets.UTF_8));
      Excerpt excerpt = read(part, 0, READ_AT_ONCE);
      for (long read = 0; excerpt.bytes().length > 0 && at <= limit; ) {
        at = put(ended.buildId(), at, excerpt.bytes());
        read += excerpt.bytes().length;
        excerpt = read(part, read, READ_AT_ONCE);
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
        .orElseThrow(() -> Refusal.notFound("build", buildId));
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
      insert(buildId, limit, CUT);
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
