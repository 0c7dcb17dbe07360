package org.sitaf.server.build.request;

import java.time.Instant;

/** Which fire time of which schedule asked for a build; at most one build comes of it. */
public record Reservation(String scheduleId, Instant fireTime) {}
