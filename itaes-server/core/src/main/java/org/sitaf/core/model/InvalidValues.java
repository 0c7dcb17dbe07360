package org.sitaf.core.model;

/** How values outside the declared class take part in cases. */
public enum InvalidValues {
  /** Never two invalid values in one case, so that one error cannot mask another. */
  ISOLATE,
  /** All values alike. */
  COMBINE;

  /** As documents spell it. */
  public String spelling() {
    return this == ISOLATE ? "isolate" : "combine";
  }
}
