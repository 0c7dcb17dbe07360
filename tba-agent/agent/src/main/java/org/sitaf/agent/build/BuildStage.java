package org.sitaf.agent.build;

/** The stages of a build, in order. */
public enum BuildStage {
  PREPARING,
  COMPILING,
  RUNNING
}
