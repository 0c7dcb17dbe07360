package org.sitaf.core.description;

/** The direction in which a parameter passes data. */
public enum Direction {
  IN,
  OUT,
  INOUT
}
