package org.sitaf.core.flaky;

/** What makes equal runs of a case differ. */
public enum FlakyCause {
  COMPONENT("the component"),
  SIMULATOR("the simulator"),
  MACHINE("the machine"),
  /** Only an earlier result differs, of which no signals are known. */
  UNKNOWN("cause not known");

  private final String words;

  FlakyCause(String words) {
    this.words = words;
  }

  public String words() {
    return words;
  }
}
