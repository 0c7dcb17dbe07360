package org.sitaf.server.result.coverage;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.sitaf.server.file.StoredFiles;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** The activity's files as they were stored with a build. */
@Repository
class BuiltSources {
  /** Folder of the activity in a test application. */
  private static final String ACTIVITY = "activity/";

  private final JdbcClient jdbc;
  private final StoredFiles files;

  BuiltSources(JdbcClient jdbc, StoredFiles files) {
    this.jdbc = jdbc;
    this.files = files;
  }

  /** Returns the text of a file; invalid UTF-8 is replaced. */
  Optional<String> text(String buildId, String path) {
    return jdbc.sql("SELECT sha256 FROM build_file WHERE build_id = ? AND path = ?")
        .params(buildId, ACTIVITY + path)
        .query(String.class)
        .optional()
        .map(sha256 -> new String(files.content(sha256), StandardCharsets.UTF_8));
  }
}
