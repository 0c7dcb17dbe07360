package org.sitaf.agent.executor;

/**
 * Where the output of test applications and the agent's remarks on it go. Safe to use from several
 * threads.
 */
public interface OutputSink {
  /**
   * Output of a test application; an amount that nobody would read may be cut.
   *
   * @param caseNo the case that printed it; 0 where none did
   */
  void output(String text, int caseNo);

  /** A remark of the agent, one line without its end; not cut before there are very many. */
  void remark(String line);
}
