package org.sitaf.server.build.request;

/** Of which cases of a build it is recorded what moved in the simulation. */
public enum RecordedCases {
  /** Of none. */
  NONE,
  /** Of those that end as FAIL or ERROR. */
  FAILED,
  /** Of all. */
  ALL;

  /**
   * A person may look at each of so many, and waits a moment longer for them. Recording takes a
   * case many times what the case takes by itself, whether it is kept or not, so that more are
   * recorded only for those who ask for it.
   */
  private static final int FEW = 100;

  /** What is recorded where nobody says so. */
  public static RecordedCases byDefault(int cases) {
    return cases <= FEW ? ALL : NONE;
  }
}
