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
 * @param dataDirectory folder of the database and {@code ports.properties}; absolute, or beginning
 *     with {@code ./}
 * @param logDirectory folder of build logs of earlier releases, which are imported into the
 *     database once; null for {@code logs} in the data directory
 * @param publicHosts host names under which users reach the server, in addition to localhost
 * @param trustedProxies addresses and ranges, such as {@code 10.0.0.0/8}, of reverse proxies whose
 *     headers are used: {@code X-Forwarded-For}, {@code X-Forwarded-Proto}, {@code Forwarded}
 * @param lease an agent that sends nothing for this long is considered lost
 * @param maxAttempts maximum number of attempts of a build when the infrastructure fails
 * @param retryDelay delay after the first infrastructure failure of a build; it doubles after each
 *     further one, up to a minute
 * @param maxUpload maximum size of a request body
 * @param maxLog maximum size of a build's log; the rest is dropped, with a note
 * @param maxRecordings maximum total size of a build's recordings
 * @param maxSignals maximum total size of the signals of a build's cases
 * @param minFree with less free space on the disk of the data the server accepts no new work, and
 *     with less than a quarter of it writes nothing; 0 disables the check
 * @param stopWithStdin whether the server stops when its standard input is closed, so that it does
 *     not outlive its launcher
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
    @DefaultValue("32MB") DataSize maxSignals,
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
