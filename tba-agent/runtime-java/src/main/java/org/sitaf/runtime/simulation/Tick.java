package org.sitaf.runtime.simulation;

/** The work of a periodic component in one period. */
@FunctionalInterface
public interface Tick {
  /**
   * Executes one period.
   *
   * @throws Exception what the component throws; it ends the case
   */
  void tick() throws Exception;
}
