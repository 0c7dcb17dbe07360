package org.sitaf.server.build;

/** What an agent does with the test application of a build. */
public enum BuildKind {
  /** It executes the cases. */
  TEST("test"),
  /** It searches the causes of the failures of another build, with further cases. */
  EXPLANATION("explanation"),
  /** It scores the specification of another build, with faults between driver and component. */
  SCORE("score"),
  /** It executes the cases of another build again, and compares the runs. */
  REPETITION("repetition");

  private final String words;

  BuildKind(String words) {
    this.words = words;
  }

  /** The kind in messages. */
  public String words() {
    return words;
  }
}
