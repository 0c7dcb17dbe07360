package org.sitaf.server.file;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.dao.DuplicateKeyException;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/**
 * Keeps file contents by their SHA-256, each once. Contents are stored on their own, before what
 * refers to them, so that two who store the same content at the same time cannot undo each other's
 * work.
 */
@Repository
public class StoredFiles {
  private static final Duration KEPT = Duration.ofHours(1);
  private static final OffsetDateTime NEVER = Instant.EPOCH.atOffset(ZoneOffset.UTC);

  private final JdbcClient jdbc;
  private final DiskSpace disk;
  private final Clock clock;

  StoredFiles(JdbcClient jdbc, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.disk = disk;
    this.clock = clock;
  }

  /** Stores the files of a tree. Not to be called within a transaction. */
  public List<StoredFile> store(FileTree tree) {
    List<StoredFile> files = new ArrayList<>();
    for (String path : tree.paths()) {
      byte[] content = tree.content(path).orElseThrow();
      files.add(new StoredFile(path, store(content), content.length));
    }
    return List.copyOf(files);
  }

  /** Reads the files back. */
  public FileTree load(Collection<StoredFile> files) {
    Map<String, byte[]> contents = new HashMap<>();
    for (StoredFile file : files) {
      contents.put(file.path(), content(file.sha256()));
    }
    return FileTree.of(contents);
  }

  /** The content of a digest that is known to be stored. */
  public byte[] content(String sha256) {
    return jdbc.sql("SELECT content FROM file_content WHERE sha256 = ?")
        .param(sha256)
        .query((row, index) -> row.getBytes(1))
        .single();
  }

  /** SHA-256 in hexadecimal. */
  public static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  /**
   * Stores a content. Not to be called within a transaction.
   *
   * @return its digest
   * @throws org.sitaf.server.refusal.Refusal when there is no room for it
   */
  public String store(byte[] content) {
    String sha256 = sha256(content);
    if (!keep(sha256)) {
      disk.requireFor(content.length);
      try {
        jdbc.sql("INSERT INTO file_content (sha256, size, content, stored) VALUES (?, ?, ?, ?)")
            .params(sha256, (long) content.length, content, now())
            .update();
      } catch (DuplicateKeyException e) {
        // Somebody stored the same content between the two statements: it is there, which is all
        // that was wanted.
        return sha256;
      }
    }
    return sha256;
  }

  /**
   * Makes sure that a content which is there is not collected soon.
   *
   * @return false when it is not there
   */
  private boolean keep(String sha256) {
    Optional<OffsetDateTime> stored =
        jdbc.sql("SELECT COALESCE(stored, :never) FROM file_content WHERE sha256 = :sha256")
            .param("never", NEVER)
            .param("sha256", sha256)
            .query((row, index) -> row.getObject(1, OffsetDateTime.class))
            .optional();
    if (stored.isPresent() && stored.get().isAfter(now().minus(KEPT.dividedBy(2)))) {
      return true;
    }
    return stored.isPresent()
        && jdbc.sql("UPDATE file_content SET stored = ? WHERE sha256 = ?")
                .params(now(), sha256)
                .update()
            == 1;
  }

  /**
   * Deletes contents that nothing refers to, and that nobody can be about to refer to because they
   * were stored a while ago.
   *
   * @return how many
   */
  public int collect() {
    return jdbc.sql(
            "DELETE FROM file_content WHERE (stored IS NULL OR stored < ?)"
                + " AND NOT EXISTS (SELECT 1 FROM workspace_file w"
                + " WHERE w.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM build_file b"
                + " WHERE b.sha256 = file_content.sha256)"
                + " AND NOT EXISTS (SELECT 1 FROM recording r"
                + " WHERE r.sha256 = file_content.sha256)")
        .param(now().minus(KEPT))
        .update();
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
