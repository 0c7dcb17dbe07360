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
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.stereotype.Component;

/**
 * Sees to it that somebody can get in: where no administrator has a password, one is made and
 * written to a file that only the server's user can read. It goes away when the password is
 * changed. A launcher gets in without.
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
      } else if (!users.anAdministratorHasAPassword()) {
        write(
            users
                .firstAdministrator()
                .map(present -> users.resetPassword(present.id()))
                .orElseGet(() -> users.create(NAME, Role.ADMINISTRATOR)));
      }
    } catch (Refusal e) {
      // Another server on the same database was quicker, and has written it.
      return;
    }
  }

  /** The first password is the first one no more. */
  @EventListener
  void on(Users.PasswordChange change) {
    if (change.user().role() == Role.ADMINISTRATOR) {
      try {
        Files.deleteIfExists(file);
      } catch (IOException e) {
        log.warn("{} holds a password that is used no more; delete it: {}", file, e.getMessage());
      }
    }
  }

  /**
   * By renaming, so that nobody reads half of it; not to the log, nor to the console: those are
   * kept.
   */
  private void write(Users.WithPassword made) {
    try {
      Files.createDirectories(file.getParent());
      Path fresh = file.resolveSibling("first-password.new");
      Files.deleteIfExists(fresh);
      Files.createFile(fresh, OWNER_ONLY);
      Files.writeString(
          fresh, made.password() + "\n", StandardCharsets.UTF_8, StandardOpenOption.WRITE);
      Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    System.out.println(
        "sign in as '"
            + made.user().name()
            + "' with the password in "
            + file
            + " and change it in the portal, which deletes the file");
    System.out.flush();
  }
}
