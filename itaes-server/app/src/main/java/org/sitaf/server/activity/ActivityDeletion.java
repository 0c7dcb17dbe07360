package org.sitaf.server.activity;

/**
 * A workspace is about to be deleted, with its suites, builds and results. A listener that throws a
 * {@link org.sitaf.server.refusal.Refusal} keeps it.
 */
public record ActivityDeletion(String workspaceId) {}
