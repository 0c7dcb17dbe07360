package org.sitaf.runtime.suite;

/** How a case ended. The agent, which knows the expected values, decides the verdict later. */
public enum Outcome {
  /** The call returned, and its outputs are recorded. */
  RETURNED,
  /** The call under test threw an exception. */
  THREW,
  /** Anything else failed: creation, set-up, a periodic tick, a limit. */
  ERROR,
  /** The component was not called. */
  NOT_CALLED
}
