package org.sitaf.server.computation;

import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.time.Duration;
import org.hibernate.validator.constraints.time.DurationMax;
import org.hibernate.validator.constraints.time.DurationMin;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.computation.*} of the server.
 *
 * @param atOnce how many computations run at once; 0 for as many as there are processors, at least
 *     2. A person gets half of them.
 * @param preview how long the preview of a model may take
 * @param generation how long the generation of a suite, or of its expected values, may take
 * @param patience how long a request waits until its computation may begin
 */
@Validated
@ConfigurationProperties("sitaf.computation")
public record ComputationSettings(
    @Min(0) @Max(256) @DefaultValue("0") int atOnce,
    @DurationMin(millis = 100) @DurationMax(minutes = 10) @DefaultValue("30s") Duration preview,
    @DurationMin(millis = 100) @DurationMax(hours = 2) @DefaultValue("5m") Duration generation,
    @DurationMin(millis = 0) @DurationMax(minutes = 10) @DefaultValue("30s") Duration patience) {
  int places() {
    return atOnce > 0 ? atOnce : Math.max(2, Runtime.getRuntime().availableProcessors());
  }
}
