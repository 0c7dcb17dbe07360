package org.sitaf.core.verdict;

/** The verdict of a case, from best to worst. */
public enum Verdict {
  /** As expected, or nothing was expected and the call returned. */
  PASS,
  /** A wrong value or a violated post-condition. */
  FAIL,
  /** An exception, a crash, a timeout, or a condition that could not be evaluated. */
  ERROR,
  /** Not executed; the message says why. */
  DONT;

  /** The worse of this and another verdict. */
  public Verdict worse(Verdict other) {
    return compareTo(other) >= 0 ? this : other;
  }
}
