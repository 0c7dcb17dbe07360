package org.sitaf.agent.executor;

/** Receives the output of test applications and the agent's remarks. Thread-safe. */
public interface OutputSink {
  /**
   * Output of a test application; large amounts may be cut.
   *
   * @param caseNo the case that printed it; 0 outside of cases
   */
  void output(String text, int caseNo);

  /** A remark of the agent, one line without line break; cut only if there are very many. */
  void remark(String line);
}
