package org.sitaf.server.build.log;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;
import org.springframework.transaction.event.TransactionalEventListener;

/**
 * The logs of builds, attempt after attempt in one file. The length in the database is what counts:
 * bytes beyond it in a file were never acknowledged and are written over.
 */
@Component
public class BuildLogs {
  private static final byte[] CUT =
      "\n[the log is cut here: it is larger than this server keeps]\n"
          .getBytes(StandardCharsets.UTF_8);

  private static final int READ_AT_ONCE = 1 << 20;

  private final Path directory;
  private final long limit;
  private final Attempts attempts;
  private final JdbcClient jdbc;

  BuildLogs(SitafSettings settings, Attempts attempts, JdbcClient jdbc) {
    this.directory = settings.logs();
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
    write(key.buildId(), end, ByteBuffer.wrap(chunk, known, chunk.length - known));
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
    long length = length(buildId, "");
    long end = length > limit ? limit + CUT.length : length;
    if (offset < 0 || offset > end) {
      throw Refusal.malformed("offset must be between 0 and the end of the log, " + end + ".");
    }
    ByteBuffer bytes = ByteBuffer.allocate((int) Math.min(atMost, end - offset));
    if (bytes.hasRemaining()) {
      try (FileChannel file = FileChannel.open(path(buildId), StandardOpenOption.READ)) {
        while (bytes.hasRemaining() && file.read(bytes, offset + bytes.position()) >= 0) {
          // Reads on until the excerpt is whole.
        }
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return new Excerpt(java.util.Arrays.copyOf(bytes.array(), bytes.position()), end);
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
  @TransactionalEventListener
  @Transactional(propagation = Propagation.REQUIRES_NEW)
  public void on(BuildEvent.PartsEnded ended) {
    long at = 0;
    int no = 0;
    for (String part : ended.partIds()) {
      no++;
      String title = "== shard %d of %d\n".formatted(no, ended.partIds().size());
      at = put(ended.buildId(), at, title.getBytes(StandardCharsets.UTF_8));
      Excerpt excerpt = read(part, 0, READ_AT_ONCE);
      for (long read = 0; excerpt.bytes().length > 0; ) {
        at = put(ended.buildId(), at, excerpt.bytes());
        read += excerpt.bytes().length;
        excerpt = read(part, read, READ_AT_ONCE);
      }
    }
    jdbc.sql("UPDATE build SET log_length = ? WHERE id = ?").params(at, ended.buildId()).update();
  }

  private long put(String buildId, long at, byte[] bytes) {
    write(buildId, at, ByteBuffer.wrap(bytes));
    return at + bytes.length;
  }

  @TransactionalEventListener
  void on(BuildEvent.Deleted deleted) throws IOException {
    for (String id : deleted.buildIds()) {
      Files.deleteIfExists(path(id));
    }
  }

  private long length(String buildId, String lock) {
    return jdbc.sql("SELECT log_length FROM build WHERE id = ?" + lock)
        .param(buildId)
        .query(Long.class)
        .optional()
        .orElseThrow(() -> Refusal.notFound("build", buildId));
  }

  private void write(String buildId, long at, ByteBuffer bytes) {
    if (at > limit) {
      return;
    }
    boolean cut = at + bytes.remaining() > limit;
    if (cut) {
      bytes.limit(bytes.position() + (int) (limit - at));
    }
    Path path = path(buildId);
    try {
      Files.createDirectories(directory);
      try (FileChannel file =
          FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
        long position = writeFully(file, bytes, at);
        if (cut) {
          writeFully(file, ByteBuffer.wrap(CUT), position);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("cannot write the log " + path, e);
    }
  }

  private static long writeFully(FileChannel file, ByteBuffer bytes, long at) throws IOException {
    long position = at;
    while (bytes.hasRemaining()) {
      position += file.write(bytes, position);
    }
    return position;
  }

  private Path path(String buildId) {
    return directory.resolve(buildId + ".log");
  }
}
