package org.sitaf.server.build;

/** Which attempt of which build, and the proof that it is the one that was assigned. */
public record AttemptKey(String buildId, int no, long token) {}
