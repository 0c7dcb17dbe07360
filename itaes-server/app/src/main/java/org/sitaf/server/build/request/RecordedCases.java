package org.sitaf.server.build.request;

/** Of which cases of a build it is recorded what moved in the simulation. */
public enum RecordedCases {
  /** Of none. */
  NONE,
  /** Of those that end as FAIL or ERROR. */
  FAILED,
  /** Of all. */
  ALL;

  /** A person may look at each of so many. */
  private static final int FEW = 200;

  /** Recording takes milliseconds a case, which nobody who did not ask for it is to wait for. */
  private static final int MANY = 2000;

  /** What is recorded where nobody says so. */
  public static RecordedCases byDefault(int cases) {
    if (cases <= FEW) {
      return ALL;
    }
    return cases <= MANY ? FAILED : NONE;
  }
}
