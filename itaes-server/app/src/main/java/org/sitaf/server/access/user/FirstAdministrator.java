package org.sitaf.server.access.user;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.SitafSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.stereotype.Component;

/**
 * Makes sure that an administrator can sign in. If no administrator has a password, one is
 * generated and written to a file that only the server's user can read. The file is deleted when
 * the password is changed. With a launcher token no password is needed.
 */
@Component
class FirstAdministrator {
  private static final Logger log = LoggerFactory.getLogger(FirstAdministrator.class);
  private static final String NAME = "administrator";
  private static final FileAttribute<Set<PosixFilePermission>> OWNER_ONLY =
      PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"));

  private final Users users;
  private final AccessSettings settings;
  private final Path file;

  FirstAdministrator(Users users, AccessSettings settings, SitafSettings server) {
    this.users = users;
    this.settings = settings;
    this.file = server.dataDirectory().toAbsolutePath().normalize().resolve("first-password");
  }

  @EventListener
  @Order(Ordered.HIGHEST_PRECEDENCE)
  void on(ApplicationReadyEvent ready) throws IOException {
    try {
      if (settings.launcherToken() != null) {
        if (users.firstAdministrator().isEmpty()) {
          users.createWithoutPassword(NAME, Role.ADMINISTRATOR);
        }
      } else if (!users.hasAdministratorWithPassword()) {
        write(
            users
                .firstAdministrator()
                .map(present -> users.resetPassword(present.id()))
                .orElseGet(() -> users.create(NAME, Role.ADMINISTRATOR)));
      }
    } catch (RequestException e) {
      // Another server on the same database created the administrator first.
      return;
    }
  }

  @EventListener
  void on(Users.PasswordChange change) {
    if (change.user().role() == Role.ADMINISTRATOR) {
      try {
        Files.deleteIfExists(file);
      } catch (IOException e) {
        log.warn("{} contains an outdated password; delete it: {}", file, e.getMessage());
      }
    }
  }

  /**
   * Writes to a file because logs and console output are kept; renames it so that readers never see
   * a partial file.
   */
  private void write(Users.WithPassword created) {
    try {
      Files.createDirectories(file.getParent());
      Path temporary = file.resolveSibling("first-password.new");
      Files.deleteIfExists(temporary);
      Files.createFile(temporary, OWNER_ONLY);
      Files.writeString(
          temporary, created.password() + "\n", StandardCharsets.UTF_8, StandardOpenOption.WRITE);
      Files.move(
          temporary, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    System.out.println(
        "sign in as '"
            + created.user().name()
            + "' with the password in "
            + file
            + " and change it in the portal, which deletes the file");
    System.out.flush();
  }
}
