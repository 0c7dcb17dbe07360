package org.sitaf.agent.build;

import java.nio.file.Path;
import org.sitaf.core.verdict.CaseResult;

/** Is told what a build does, from the build's own threads; must return soon. */
public interface BuildListener {
  /** The build entered a stage. */
  void stage(BuildStage stage);

  /** The build's log grew by these bytes of UTF-8. */
  void log(byte[] utf8);

  /** A case has its result, judged. */
  void caseFinished(CaseResult result);

  /**
   * It is known what moved in a case that has finished.
   *
   * @param recording binary glTF, the build's own copy
   */
  void recorded(int no, Path recording);
}
