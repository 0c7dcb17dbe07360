package org.sitaf.core.diagnostic;

/** How much a diagnostic matters. */
public enum Severity {
  /** The input cannot be used. */
  ERROR,
  /** The input can be used, but something in it was left out or is probably a mistake. */
  WARNING
}
