package org.sitaf.server.access;

import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
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
 * @param launcherToken API token of the command that started this server on the same machine; valid
 *     while the server runs, on the loopback interface only
 * @param launcherEnrolment enrolment token for the agents of that command; it can be used any
 *     number of times
 * @param plaintext whether the server may listen on other interfaces without TLS because a reverse
 *     proxy terminates TLS
 * @param auditRetention how long audit events are kept
 * @param passwordStrength binary logarithm of the rounds of bcrypt for new passwords
 */
@Validated
@ConfigurationProperties("sitaf.access")
public record AccessSettings(
    @Size(min = 32, max = 200) @Nullable String launcherToken,
    @Size(min = 32, max = 200) @Nullable String launcherEnrolment,
    @DefaultValue("false") boolean plaintext,
    @DurationMin(days = 1) @DefaultValue("365d") Duration auditRetention,
    @Min(10) @Max(16) @DefaultValue("12") int passwordStrength) {
  @Override
  public String toString() {
    return "AccessSettings[plaintext="
        + plaintext
        + ", auditRetention="
        + auditRetention
        + ", passwordStrength="
        + passwordStrength
        + "]";
  }
}
