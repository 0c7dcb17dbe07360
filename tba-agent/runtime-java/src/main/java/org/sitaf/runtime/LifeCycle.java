package org.sitaf.runtime;

/** When a component under test is made and closed. */
public enum LifeCycle {
  /** Anew for each case. */
  CASE,
  /** Once for all cases of a process. */
  SUITE
}
