package org.sitaf.server.access;

import jakarta.validation.constraints.Size;
import java.time.Duration;
import org.hibernate.validator.constraints.time.DurationMin;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.access.*} of the server.
 *
 * @param launcherToken a token of the command that starts this server on its own machine; known
 *     while the server runs, and on the loopback only
 * @param launcherEnrolment the same for that command's agents, for any number of them
 * @param plaintext whether the server may listen without TLS beyond the loopback, because something
 *     before it ends TLS
 * @param auditRetention for how long the audit log is kept
 */
@Validated
@ConfigurationProperties("sitaf.access")
public record AccessSettings(
    @Size(min = 32, max = 200) @Nullable String launcherToken,
    @Size(min = 32, max = 200) @Nullable String launcherEnrolment,
    @DefaultValue("false") boolean plaintext,
    @DurationMin(days = 1) @DefaultValue("365d") Duration auditRetention) {
  @Override
  public String toString() {
    return "AccessSettings[plaintext=" + plaintext + ", auditRetention=" + auditRetention + "]";
  }
}
