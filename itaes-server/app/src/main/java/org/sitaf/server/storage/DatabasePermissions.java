package org.sitaf.server.storage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.stereotype.Component;

/**
 * Restricts the database file to its owner, so that copies with the same permissions are private,
 * too.
 */
@Component
class DatabasePermissions {
  private final Path database;

  DatabasePermissions(SitafSettings settings) {
    database = settings.dataDirectory().resolve("database.mv.db");
  }

  @EventListener
  @Order(Ordered.HIGHEST_PRECEDENCE)
  void on(ApplicationReadyEvent ready) throws IOException {
    if (Files.exists(database) && Files.getFileStore(database).supportsFileAttributeView("posix")) {
      Files.setPosixFilePermissions(database, PosixFilePermissions.fromString("rw-------"));
    }
  }
}
