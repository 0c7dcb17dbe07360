package org.sitaf.core.diagnostic;

/** The severity of a diagnostic. */
public enum Severity {
  /** The input cannot be used. */
  ERROR,
  /** The input can be used, but a part of it was ignored or is probably a mistake. */
  WARNING
}
