package org.sitaf.core.combine;

/**
 * How long to search for a smaller array. Counted in search steps instead of time, so results are
 * reproducible.
 */
public enum Effort {
  /** Returns the first complete array. */
  FAST,
  /** About a second for pairs, some seconds for higher strengths. */
  DEFAULT,
  /** Up to about two minutes. */
  BEST
}
