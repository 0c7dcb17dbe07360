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

/** A copy of the database, made with its permissions, is nobody else's to read either. */
@Component
class PrivateFiles {
  private final Path database;

  PrivateFiles(SitafSettings settings) {
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
