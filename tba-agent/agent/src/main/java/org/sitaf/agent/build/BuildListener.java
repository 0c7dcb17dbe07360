package org.sitaf.agent.build;

import java.nio.file.Path;
import org.sitaf.agent.simulation.LiveMotion;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;

/**
 * Receives the events of a build. Called in the build's threads, so methods must return quickly.
 */
public interface BuildListener {
  /** The build entered a stage. */
  void stage(BuildStage stage);

  /** A stage that takes long does something, for people. */
  default void progress(String text) {
    // Only commands show it at once; the log contains it, too.
  }

  /** The build's log grew by these bytes of UTF-8. */
  void log(byte[] utf8);

  /** The simulation is ready; the motion of recorded cases can be watched until the build ends. */
  default void simulated(LiveMotion motion) {
    // Only a debugged case is watched.
  }

  /** The record of a case, before it has a result. */
  default void caseRecorded(CaseRecord record) {
    // Most listeners need the result only.
  }

  /** A case has a result with its final verdict. */
  void caseFinished(CaseResult result);

  /**
   * The signals of a finished case, if the build records signals.
   *
   * @param trace not to be changed
   */
  default void signals(int no, Trace trace) {
    // Most listeners do not need them.
  }

  /**
   * The recording of a finished case is available.
   *
   * @param recording binary glTF, the build's own copy
   */
  void recorded(int no, Path recording);

  /**
   * The recording of the second run of a finished case is available.
   *
   * @param relation index of the relation in the model, from 1
   * @param recording binary glTF, the build's own copy
   */
  default void secondRunRecorded(int no, int relation, Path recording) {
    // Only agents send it to a server.
  }

  /** The signals of a finished case are kept for a server. */
  default void signalsKept(int no, SignalExcerpt signals) {
    // Only agents send them to a server.
  }
}
