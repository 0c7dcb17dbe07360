package org.sitaf.core.model;

/** The target of an input value (paper, section 3.1). */
public enum InputKind {
  /** Test data of input: a parameter of the method under test. */
  TDI,
  /** Test data of simulation dependency: a parameter of the world. */
  TDSD,
  /** Test data of test stub: a result of a required interface. */
  TDTS
}
