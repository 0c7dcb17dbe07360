package org.sitaf.agent.manager;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.sitaf.agent.build.SignalExcerpt;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.ConditionSpan;
import org.sitaf.agent.v1.SampledSignal;

/** Files with the signals of a case that wait for their upload: encoded {@link CaseSignals}. */
final class SignalFiles {
  /** File names are {@code NO.signals}. */
  static final String SUFFIX = ".signals";

  private SignalFiles() {}

  /**
   * Writes the file of a case.
   *
   * @param folder created if missing
   */
  static Path write(Path folder, int no, SignalExcerpt excerpt) throws IOException {
    Files.createDirectories(folder);
    return Files.write(folder.resolve(no + SUFFIX), encode(excerpt).toByteArray());
  }

  private static CaseSignals encode(SignalExcerpt excerpt) {
    CaseSignals.Builder signals = CaseSignals.newBuilder().setSamples(excerpt.samples());
    Arrays.stream(excerpt.nanos()).forEach(signals::addTimesNs);
    for (SignalExcerpt.Signal signal : excerpt.signals()) {
      SampledSignal.Builder added =
          signals.addSignalsBuilder().setName(signal.name()).setUnit(signal.unit());
      Arrays.stream(signal.values()).forEach(added::addValues);
    }
    for (org.sitaf.core.trajectory.ConditionSpan span : excerpt.conditions()) {
      signals.addConditions(
          ConditionSpan.newBuilder()
              .setName(span.name())
              .setFromNs(span.fromNanos())
              .setToNs(span.toNanos())
              .addAllSignals(span.signals()));
    }
    return signals.build();
  }
}
