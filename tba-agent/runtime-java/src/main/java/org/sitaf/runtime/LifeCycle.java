package org.sitaf.runtime;

/** How long an instance of the component under test is used. */
public enum LifeCycle {
  /** A new instance for each case. */
  CASE,
  /** One instance for all cases of a process. */
  SUITE
}
