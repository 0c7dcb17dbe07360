package org.sitaf.cli.debug;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.simulation.LiveMotion;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;

/**
 * Follows the case that is debugged, and prints nothing: the terminal belongs to the debugger.
 *
 * @param signals receives the signals of the case
 * @param scene null if nobody watches
 */
public record DebuggedCase(BiConsumer<Integer, Trace> signals, @Nullable SceneServer scene)
    implements BuildListener {
  @Override
  public void stage(BuildStage stage) {
    // The debugger shows where the component is.
  }

  @Override
  public void log(byte[] utf8) {
    // The output of the component would mix with that of the debugger.
  }

  @Override
  public void simulated(LiveMotion motion) {
    if (scene != null) {
      scene.show(motion);
    }
  }

  @Override
  public void recorded(int no, Path recording) {
    if (scene != null) {
      try {
        scene.end(recording);
      } catch (IOException e) {
        throw new UncheckedIOException("cannot read the recording of case " + no, e);
      }
    }
  }

  @Override
  public void signals(int no, Trace trace) {
    signals.accept(no, trace);
  }

  @Override
  public void caseFinished(CaseResult result) {
    // The result is printed after the debugger has ended.
  }
}
