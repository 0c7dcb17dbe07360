package org.sitaf.runtime.suite;

/** How a case ended. */
public enum Verdict {
  /** As expected, or nothing was expected and the call returned. */
  PASS,
  /** An output has a wrong value. */
  FAIL,
  /** The component threw an exception, or the case could not be judged. */
  ERROR,
  /** The component was not called; the message says why. */
  DONT
}
