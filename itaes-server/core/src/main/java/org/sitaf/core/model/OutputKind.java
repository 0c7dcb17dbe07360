package org.sitaf.core.model;

/** Where a test looks for an outcome. */
public enum OutputKind {
  /** The return value of the method under test. */
  RETURN,
  /** An out-parameter of the method under test. */
  OUT,
  /** An observation of the world, or an output data port of the component. */
  OBSERVED
}
