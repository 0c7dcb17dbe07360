package org.sitaf.core.combine;

/** Hears how a combination gets on. Called on the thread that combines. */
@FunctionalInterface
public interface Progress {
  /** Nobody listens. */
  Progress NONE = (rows, share) -> {};

  /**
   * A complete array exists, or more of the effort is spent.
   *
   * @param rows rows of the smallest complete array so far
   * @param share how much of the effort is spent, 0 to 1
   */
  void report(int rows, double share);
}
