package org.sitaf.core.description;

/** Which way a parameter carries data. */
public enum Direction {
  IN,
  OUT,
  INOUT
}
