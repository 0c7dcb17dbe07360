package org.sitaf.server.build;

/** Identifies an attempt of a build; the fencing token proves that it was assigned to the agent. */
public record AttemptKey(String buildId, int no, long token) {}
