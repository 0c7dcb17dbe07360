package org.sitaf.core.model;

/** How test cases combine values outside the equivalence class. */
public enum InvalidValues {
  /** At most one invalid value per case, so one error cannot mask another. */
  ISOLATE,
  /** Invalid values are combined like valid ones. */
  COMBINE;

  /** The value in documents. */
  public String text() {
    return this == ISOLATE ? "isolate" : "combine";
  }
}
