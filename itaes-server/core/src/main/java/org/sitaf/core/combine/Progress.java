package org.sitaf.core.combine;

/** Receives the progress of a combination, on the thread of the combination. */
@FunctionalInterface
public interface Progress {
  /** Ignores progress. */
  Progress NONE = (rows, share) -> {};

  /**
   * Called when a smaller array was found or more of the effort was used.
   *
   * @param rows number of rows of the smallest complete array so far
   * @param share used share of the effort, 0 to 1
   */
  void report(int rows, double share);
}
