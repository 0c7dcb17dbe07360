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
 * @param atOnce maximum number of concurrent computations, of which a user gets half; 0 for the
 *     number of processors, but at least 2
 * @param preview time limit of the preview of a model
 * @param generation time limit of generating a suite or its expected values
 * @param queueTimeout how long a request waits for its computation to start
 */
@Validated
@ConfigurationProperties("sitaf.computation")
public record ComputationSettings(
    @Min(0) @Max(256) @DefaultValue("0") int atOnce,
    @DurationMin(millis = 100) @DurationMax(minutes = 10) @DefaultValue("30s") Duration preview,
    @DurationMin(millis = 100) @DurationMax(hours = 2) @DefaultValue("5m") Duration generation,
    @DurationMin(millis = 0) @DurationMax(minutes = 10) @DefaultValue("30s")
        Duration queueTimeout) {
  int permits() {
    return atOnce > 0 ? atOnce : Math.max(2, Runtime.getRuntime().availableProcessors());
  }
}
