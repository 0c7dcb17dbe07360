package org.sitaf.agent.build;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.StepRecord;

/** The number of the current step as a signal of a case: 0 before the first step. */
final class SequenceSignal {
  private SequenceSignal() {}

  /** A copy of the signals of a case with the number of the step at each sample. */
  static Trace added(Trace trace, List<StepRecord> steps) {
    if (trace.names().contains(SequenceSpec.STEP)) {
      return trace;
    }
    double[] column = new double[trace.count()];
    int current = 0;
    for (int sample = 0; sample < column.length; sample++) {
      while (current < steps.size() && steps.get(current).atNanos() <= trace.nanos(sample)) {
        current++;
      }
      column[sample] = current;
    }
    List<String> names = new ArrayList<>(trace.names());
    names.add(SequenceSpec.STEP);
    List<double[]> columns = new ArrayList<>(trace.columns());
    columns.add(column);
    return new Trace(trace.firstNanos(), trace.stepNanos(), names, columns);
  }
}
