package org.sitaf.cli.run;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;

/** Shows the progress of a build, and hands over the signals of its cases. */
record BuildProgress(
    String model,
    int total,
    ProgressLine progress,
    SignalFolder folder,
    BiConsumer<Integer, Trace> observer,
    AtomicInteger done)
    implements BuildListener {
  BuildProgress(
      String model,
      int total,
      ProgressLine progress,
      SignalFolder folder,
      BiConsumer<Integer, Trace> observer) {
    this(model, total, progress, folder, observer, new AtomicInteger());
  }

  @Override
  public void signals(int no, Trace trace) {
    folder.write(no, trace);
    observer.accept(no, trace);
  }

  @Override
  public void stage(BuildStage stage) {
    progress.step(
        model
            + switch (stage) {
              case PREPARING -> ": preparing the simulation";
              case COMPILING -> ": compiling";
              case RUNNING -> ": running " + total + (total == 1 ? " case" : " cases");
            });
  }

  @Override
  public void progress(String text) {
    progress.step(model + ": " + text);
  }

  @Override
  public void log(byte[] utf8) {
    // The output of a component is not printed; error messages contain its last line.
  }

  @Override
  public void caseFinished(CaseResult result) {
    progress.done(done.incrementAndGet(), total);
  }

  @Override
  public void recorded(int no, Path recording) {
    // The recording is already in its destination folder.
  }
}
