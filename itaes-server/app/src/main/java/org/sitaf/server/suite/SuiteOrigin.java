package org.sitaf.server.suite;

/** The activity and the model that a suite belongs to. */
public record SuiteOrigin(String activityId, String activityName, String suiteId, String model) {}
