package org.sitaf.server.build.request;

import java.time.Instant;

/** The fire time of a schedule that requests a build; there is at most one build per fire time. */
public record Reservation(String scheduleId, Instant fireTime) {}
