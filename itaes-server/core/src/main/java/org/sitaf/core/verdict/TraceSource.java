package org.sitaf.core.verdict;

import org.sitaf.core.trajectory.Trace;

/** Provides the signals of a case. */
@FunctionalInterface
public interface TraceSource {
  /**
   * The signals of the case.
   *
   * @throws MissingTraceException if there are none
   */
  Trace trace() throws MissingTraceException;

  /** The signals of a case are not known; the message says why. */
  final class MissingTraceException extends Exception {
    private static final long serialVersionUID = 1L;

    public MissingTraceException(String message) {
      super(message);
    }
  }
}
