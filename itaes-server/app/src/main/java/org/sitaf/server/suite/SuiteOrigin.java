package org.sitaf.server.suite;

/** What a suite belongs to. */
public record SuiteOrigin(String activityId, String activityName, String suiteId, String model) {}
