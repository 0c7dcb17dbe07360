package org.sitaf.server.git;

import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.NotNull;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.hibernate.validator.constraints.time.DurationMin;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.util.unit.DataSize;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.git.*} of the server.
 *
 * @param allowedHosts hosts of repositories and forges, such as {@code git.example.org}; {@code *}
 *     allows all
 * @param privateAddresses whether such a host may have a private or loopback address
 * @param plainHttpHosts hosts that may be reached without encryption
 * @param fileFolders folders whose repositories may be fetched by {@code file:} URLs
 * @param keyFile the key that encrypts credentials; null for {@code git.key} in the data directory
 * @param publicUrl where people reach the server, for links in commit statuses
 * @param fetchTime maximum duration of a fetch
 * @param maxRepository maximum size of what is fetched of one repository
 * @param maxObject maximum size of one file of a repository, also of files that no activity needs
 * @param fetchesAtOnce maximum number of repositories that are fetched concurrently
 * @param minInterval shortest interval of polling that a user can choose
 * @param statusInterval interval in which statuses that are due are sent
 */
@Validated
@ConfigurationProperties("sitaf.git")
public record GitSettings(
    @DefaultValue("*") List<String> allowedHosts,
    @DefaultValue("false") boolean privateAddresses,
    @DefaultValue List<String> plainHttpHosts,
    @DefaultValue List<Path> fileFolders,
    @Nullable Path keyFile,
    @NotNull @DefaultValue("http://localhost:8080") URI publicUrl,
    @DurationMin(seconds = 1) @DefaultValue("5m") Duration fetchTime,
    @DefaultValue("2GB") DataSize maxRepository,
    @DefaultValue("256MB") DataSize maxObject,
    @Min(1) @DefaultValue("8") int fetchesAtOnce,
    @DurationMin(seconds = 1) @DefaultValue("30s") Duration minInterval,
    @DurationMin(millis = 10) @DefaultValue("2s") Duration statusInterval) {
  public GitSettings {
    allowedHosts = List.copyOf(allowedHosts);
    plainHttpHosts = List.copyOf(plainHttpHosts);
    fileFolders = List.copyOf(fileFolders);
  }
}
