package org.sitaf.server.settings;

import jakarta.validation.constraints.Min;
import java.time.Duration;
import org.hibernate.validator.constraints.time.DurationMin;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;
import org.springframework.util.unit.DataSize;
import org.springframework.validation.annotation.Validated;

/**
 * Settings {@code sitaf.limits.*} of the server: what a single caller gets of it. None of them
 * holds for the command that started the server on its own machine.
 *
 * @param bodyTime for how long the body of a request may be on its way; a large one gets a second
 *     more for each 16 KiB
 * @param signInBodyTime the same before anybody has signed in
 * @param uploadsAtOnce how many archives are unpacked at the same time
 * @param quota what the distinct files of a person's activities and builds may take together,
 *     unless an administrator has set another one
 * @param activities of a person
 * @param suites of a person's activities
 * @param openBuilds of a person that are not over
 * @param tokens of a person
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
