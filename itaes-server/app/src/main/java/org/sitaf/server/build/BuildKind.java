package org.sitaf.server.build;

/** What an agent does with the test application of a build. */
public enum BuildKind {
  /** It executes the cases. */
  TEST,
  /** It searches the causes of the failures of another build, with further cases. */
  EXPLANATION,
  /** It scores the specification of another build, with faults between driver and component. */
  SCORE
}
