package org.sitaf.runtime.simulation;

/** What a periodic component does once in each of its periods. */
@FunctionalInterface
public interface Tick {
  /**
   * Does the work of one period.
   *
   * @throws Exception what the component throws; it ends the case
   */
  void tick() throws Exception;
}
