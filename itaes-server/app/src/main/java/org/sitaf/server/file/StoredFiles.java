package org.sitaf.server.file;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.digest.Sha256;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/**
 * Stores each file content once, under its SHA-256. Contents are stored in separate transactions
 * before the rows that reference them, so that concurrent transactions with the same content do not
 * conflict.
 */
@Repository
public class StoredFiles {
  private static final Duration GRACE_PERIOD = Duration.ofHours(1);
  private static final OffsetDateTime NEVER = Instant.EPOCH.atOffset(ZoneOffset.UTC);

  private final JdbcClient jdbc;
  private final DiskSpace disk;
  private final Clock clock;

  StoredFiles(JdbcClient jdbc, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.disk = disk;
    this.clock = clock;
  }

  /** Stores the files of a tree. Must not be called within a transaction. */
  public List<StoredFile> store(FileTree tree) {
    List<StoredFile> files = new ArrayList<>();
    for (String path : tree.paths()) {
      byte[] content = tree.content(path).orElseThrow();
      files.add(new StoredFile(path, store(content), content.length));
    }
    return List.copyOf(files);
  }

  /** Loads the contents of files. */
  public FileTree load(Collection<StoredFile> files) {
    Map<String, byte[]> contents = new HashMap<>();
    for (StoredFile file : files) {
      contents.put(file.path(), content(file.sha256()));
    }
    return FileTree.of(contents);
  }

  /** Returns the content with a hash that is known to be stored. */
  public byte[] content(String sha256) {
    return jdbc.sql("SELECT content FROM file_content WHERE sha256 = ?")
        .param(sha256)
        .query((row, index) -> row.getBytes(1))
        .single();
  }

  /** SHA-256 in hexadecimal. */
  public static String sha256(byte[] content) {
    return Sha256.hex(content);
  }

  /**
   * Stores a content. Must not be called within a transaction.
   *
   * @return its SHA-256 in hexadecimal
   * @throws org.sitaf.server.error.RequestException if the disk is full
   */
  public String store(byte[] content) {
    String sha256 = sha256(content);
    if (!touch(sha256)) {
      disk.requireFor(content.length);
      try {
        jdbc.sql("INSERT INTO file_content (sha256, size, content, stored) VALUES (?, ?, ?, ?)")
            .params(sha256, (long) content.length, content, now())
            .update();
      } catch (DuplicateKeyException e) {
        // Another transaction stored the same content between the two statements.
        return sha256;
      }
    }
    return sha256;
  }

  /**
   * Restarts the grace period of a content.
   *
   * @return false if the content is not stored
   */
  private boolean touch(String sha256) {
    Optional<OffsetDateTime> stored =
        jdbc.sql("SELECT COALESCE(stored, :never) FROM file_content WHERE sha256 = :sha256")
            .param("never", NEVER)
            .param("sha256", sha256)
            .query((row, index) -> row.getObject(1, OffsetDateTime.class))
            .optional();
    if (stored.isPresent() && stored.get().isAfter(now().minus(GRACE_PERIOD.dividedBy(2)))) {
      return true;
    }
    return stored.isPresent()
        && jdbc.sql("UPDATE file_content SET stored = ? WHERE sha256 = ?")
                .params(now(), sha256)
                .update()
            == 1;
  }

  /**
   * Deletes contents that are not referenced and whose grace period, in which a transaction may
   * still add a reference, has ended.
   *
   * @return the number of deleted contents
   */
  public int deleteUnreferenced() {
    return jdbc.sql(
            "DELETE FROM file_content WHERE (stored IS NULL OR stored < ?)"
                + " AND NOT EXISTS (SELECT 1 FROM activity_file w"
                + " WHERE w.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM build_file b"
                + " WHERE b.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM recording r"
                + " WHERE r.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM second_run_recording s"
                + " WHERE s.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM case_signals s"
                + " WHERE s.sha256 = file_content.sha256)")
        .param(now().minus(GRACE_PERIOD))
        .update();
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
