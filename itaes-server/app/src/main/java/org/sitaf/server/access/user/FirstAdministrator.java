package org.sitaf.server.access.user;

import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.access.Role;
import org.sitaf.server.refusal.Refusal;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.stereotype.Component;

/**
 * Sees to it that somebody can get in: where no administrator has a password, one is made up and
 * printed once. A launcher gets in without.
 */
@Component
class FirstAdministrator {
  private static final String NAME = "administrator";

  private final Users users;
  private final AccessSettings settings;

  FirstAdministrator(Users users, AccessSettings settings) {
    this.users = users;
    this.settings = settings;
  }

  @EventListener
  @Order(Ordered.HIGHEST_PRECEDENCE)
  void on(ApplicationReadyEvent ready) {
    try {
      if (settings.launcherToken() != null) {
        if (users.firstAdministrator().isEmpty()) {
          users.createWithoutPassword(NAME, Role.ADMINISTRATOR);
        }
      } else if (!users.anAdministratorHasAPassword()) {
        print(
            users
                .firstAdministrator()
                .map(present -> users.resetPassword(present.id()))
                .orElseGet(() -> users.create(NAME, Role.ADMINISTRATOR)));
      }
    } catch (Refusal e) {
      // Another server on the same database was quicker, and has printed it.
      return;
    }
  }

  /** Not by the log: that is kept. */
  private static void print(Users.WithPassword made) {
    System.out.println(
        "sign in as '"
            + made.user().name()
            + "' with the password "
            + made.password()
            + " (shown only this once; change it in the portal)");
    System.out.flush();
  }
}
