package org.sitaf.server.file;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.FileTree;
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
  private final JdbcClient jdbc;

  StoredFiles(JdbcClient jdbc) {
    this.jdbc = jdbc;
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

  private String store(byte[] content) {
    String sha256 = sha256(content);
    boolean known =
        jdbc.sql("SELECT COUNT(*) FROM file_content WHERE sha256 = ?")
                .param(sha256)
                .query(Integer.class)
                .single()
            > 0;
    if (!known) {
      try {
        jdbc.sql("INSERT INTO file_content (sha256, size, content) VALUES (?, ?, ?)")
            .params(sha256, (long) content.length, content)
            .update();
      } catch (DuplicateKeyException e) {
        // Somebody stored the same content between the two statements: it is there, which is all
        // that was wanted.
        return sha256;
      }
    }
    return sha256;
  }
}
