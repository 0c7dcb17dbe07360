package org.sitaf.core.combine;

/** How long to look for fewer rows, counted in search steps, never by the clock. */
public enum Effort {
  /** The first complete array. */
  FAST,
  /** A second or so for pairs, some seconds above. */
  DEFAULT,
  /** Up to about two minutes. */
  BEST
}
