package org.sitaf.agent.build;

/** Where a build is; it only moves forward. */
public enum BuildStage {
  PREPARING,
  COMPILING,
  RUNNING
}
