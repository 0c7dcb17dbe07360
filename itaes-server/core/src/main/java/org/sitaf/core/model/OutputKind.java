package org.sitaf.core.model;

/** The source of an output value. */
public enum OutputKind {
  /** The return value of the method under test. */
  RETURN,
  /** An out-parameter of the method under test. */
  OUT,
  /** An observation of the world, or an output data port of the component. */
  OBSERVED
}
