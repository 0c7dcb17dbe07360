package org.sitaf.server.settings;

import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.NotNull;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.hibernate.validator.constraints.time.DurationMax;
import org.hibernate.validator.constraints.time.DurationMin;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.util.unit.DataSize;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.*} of the server.
 *
 * @param dataDirectory where the database and {@code ports.properties} lie; absolute, or beginning
 *     with {@code ./}
 * @param logDirectory where earlier versions kept the logs of builds, which are imported into the
 *     database once; null for {@code logs} in the data directory
 * @param publicHosts host names, besides those of the loopback, under which people reach the server
 * @param trustedProxies addresses, and ranges such as {@code 10.0.0.0/8}, whose word is taken for
 *     whom they speak for: {@code X-Forwarded-For}, {@code X-Forwarded-Proto}, {@code Forwarded}
 * @param lease an agent from which nothing is heard for so long is taken for lost
 * @param maxAttempts how often a build is tried while only the infrastructure fails
 * @param retryDelay how long a build waits after its first failure of the infrastructure; twice as
 *     long after each further one, up to a minute
 * @param maxUpload largest body of a request
 * @param maxLog largest log of a build; what goes beyond is dropped, with a note
 * @param maxRecordings what the recordings of a build may take together
 * @param minFree with less room than this on the disk of the data no new work is taken, and with a
 *     quarter of it nothing is written; 0 asks for none
 * @param stopWithStdin whether the server ends when its standard input does, so that it never
 *     outlives a launcher
 */
@Validated
@ConfigurationProperties("sitaf")
public record SitafSettings(
    @NotNull Path dataDirectory,
    @Nullable Path logDirectory,
    @DefaultValue List<String> publicHosts,
    @DefaultValue List<String> trustedProxies,
    @DurationMin(seconds = 1) @DurationMax(minutes = 60) @DefaultValue("15s") Duration lease,
    @Min(1) @Max(100) @DefaultValue("3") int maxAttempts,
    @DurationMin(millis = 0) @DurationMax(minutes = 10) @DefaultValue("1s") Duration retryDelay,
    @DefaultValue("256MB") DataSize maxUpload,
    @DefaultValue("64MB") DataSize maxLog,
    @DefaultValue("64MB") DataSize maxRecordings,
    @DefaultValue("256MB") DataSize minFree,
    @DefaultValue("false") boolean stopWithStdin) {
  public SitafSettings {
    publicHosts = List.copyOf(publicHosts);
    trustedProxies = List.copyOf(trustedProxies);
  }

  /** Where earlier versions kept the logs of builds. */
  public Path logs() {
    return logDirectory == null ? dataDirectory.resolve("logs") : logDirectory;
  }
}
