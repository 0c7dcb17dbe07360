package org.sitaf.server.activity;

/**
 * Published before a person changes the files of an activity. A listener prevents the change by
 * throwing a {@link org.sitaf.server.error.RequestException}.
 */
public record ActivityEdit(String activityId) {}
