package org.sitaf.server.activity;

/**
 * Published before an activity is deleted with its suites, builds and results. A listener prevents
 * the deletion by throwing a {@link org.sitaf.server.error.RequestException}.
 */
public record ActivityDeletion(String activityId) {}
