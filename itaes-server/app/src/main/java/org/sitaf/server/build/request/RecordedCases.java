package org.sitaf.server.build.request;

/** Which cases of a build are recorded in the simulation. */
public enum RecordedCases {
  NONE,
  /** Cases with the verdict FAIL or ERROR. */
  FAILED,
  ALL;

  /**
   * Recording makes a case many times slower, so that larger suites are only recorded on request.
   */
  private static final int MAX_BY_DEFAULT = 100;

  /** The default for a suite with this number of cases. */
  public static RecordedCases byDefault(int cases) {
    return cases <= MAX_BY_DEFAULT ? ALL : NONE;
  }
}
