package org.sitaf.agent.build;

import java.nio.file.Path;
import org.sitaf.core.verdict.CaseResult;

/** Reports nothing of a build that is a part of another one; subclasses receive what they need. */
public class QuietBuild implements BuildListener {
  @Override
  public void stage(BuildStage stage) {
    // The other build has its own stages.
  }

  @Override
  public void log(byte[] utf8) {
    // The output of the component is not kept.
  }

  @Override
  public void caseFinished(CaseResult result) {
    // The other build reports its cases.
  }

  @Override
  public void recorded(int no, Path recording) {
    // Nothing is recorded.
  }
}
