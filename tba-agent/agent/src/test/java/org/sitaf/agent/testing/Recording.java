package org.sitaf.agent.testing;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.core.verdict.CaseResult;

/** Records the events of a build. */
public class Recording implements BuildListener {
  private final List<BuildStage> stages = new ArrayList<>();
  private final List<CaseResult> cases = new ArrayList<>();
  private final List<String> recordings = new ArrayList<>();
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();

  @Override
  public synchronized void stage(BuildStage stage) {
    stages.add(stage);
    notifyAll();
  }

  @Override
  public synchronized void log(byte[] utf8) {
    log.writeBytes(utf8);
  }

  @Override
  public synchronized void caseFinished(CaseResult result) {
    cases.add(result);
    notifyAll();
  }

  @Override
  public synchronized void recorded(int no, Path recording) {
    recordings.add(String.valueOf(recording.getFileName()));
  }

  /** Names of files. */
  public synchronized List<String> recordings() {
    return List.copyOf(recordings);
  }

  public synchronized List<BuildStage> stages() {
    return List.copyOf(stages);
  }

  public synchronized List<CaseResult> cases() {
    return List.copyOf(cases);
  }

  public synchronized String logText() {
    return log.toString(StandardCharsets.UTF_8);
  }

  /** Waits until the given number of cases have a result. */
  public synchronized void awaitCases(int number) throws InterruptedException {
    while (cases.size() < number) {
      wait();
    }
  }
}
