package org.sitaf.server.settings;

import jakarta.validation.constraints.Min;
import java.time.Duration;
import org.hibernate.validator.constraints.time.DurationMin;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.util.unit.DataSize;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.limits.*}: limits per caller. They do not apply to the command that started
 * the server on the same machine.
 *
 * @param bodyTime deadline for a request's body to arrive; a second more for each 16 KiB
 * @param signInBodyTime the same for requests that are not authenticated
 * @param uploadsAtOnce maximum number of archives that are unpacked concurrently
 * @param quota maximum size of the distinct files of a user's activities and builds, unless an
 *     administrator has set another quota
 * @param activities maximum number per user
 * @param suites maximum number per user
 * @param openBuilds maximum number of unfinished builds per user
 * @param tokens maximum number per user
 */
@Validated
@ConfigurationProperties("sitaf.limits")
public record LimitSettings(
    @DurationMin(seconds = 1) @DefaultValue("30s") Duration bodyTime,
    @DurationMin(seconds = 1) @DefaultValue("10s") Duration signInBodyTime,
    @Min(1) @DefaultValue("2") int uploadsAtOnce,
    @DefaultValue("2GB") DataSize quota,
    @Min(1) @DefaultValue("1000") int activities,
    @Min(1) @DefaultValue("5000") int suites,
    @Min(1) @DefaultValue("500") int openBuilds,
    @Min(1) @DefaultValue("100") int tokens) {}
