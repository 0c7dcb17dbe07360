package org.sitaf.server.build.log;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.sql.DataSource;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DocumentMigration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/** V93: imports the log files of earlier releases. The files are not deleted. */
@Component
class LogFilesMigration extends DocumentMigration {
  private static final Logger log = LoggerFactory.getLogger(LogFilesMigration.class);

  private final Path folder;

  @Autowired
  LogFilesMigration(SitafSettings settings) {
    this(settings.logs());
  }

  LogFilesMigration(Path folder) {
    super("93", "logs of builds in files");
    this.folder = folder;
  }

  private record Length(String buildId, long bytes) {}

  @Override
  protected void migrate(DataSource database) {
    JdbcClient jdbc = JdbcClient.create(database);
    List<Length> lengths =
        jdbc.sql("SELECT id, log_length FROM build WHERE log_length > 0")
            .query((row, index) -> new Length(row.getString(1), row.getLong(2)))
            .list();
    int imported = 0;
    for (Length length : lengths) {
      Path file = folder.resolve(length.buildId() + ".log");
      if (Files.isRegularFile(file)) {
        read(jdbc, length, file);
        imported++;
      }
    }
    if (imported > 0) {
      log.info(
          "Imported {} build logs into the database. The files in {} are no longer used and"
              + " can be deleted.",
          imported,
          folder);
    }
  }

  /** Bytes beyond the length were not acknowledged and are ignored. */
  private static void read(JdbcClient jdbc, Length length, Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      long at = 0;
      byte[] chunk = in.readNBytes(BuildLogs.MAX_CHUNK);
      while (chunk.length > 0 && at < length.bytes()) {
        int size = (int) Math.min(chunk.length, length.bytes() - at);
        BuildLogs.insert(jdbc, length.buildId(), at, Arrays.copyOf(chunk, size));
        at += size;
        chunk = in.readNBytes(BuildLogs.MAX_CHUNK);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read the log " + file, e);
    }
  }
}
