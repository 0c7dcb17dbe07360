package org.sitaf.core.score;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.score.fault.Fault;
import org.sitaf.core.score.fault.Row;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;

/** What is recorded of the cases with a fault. */
final class FaultyRecords {
  private final FaultExecutions executions;
  private final Map<Integer, CaseRecord> records;
  private final Map<Integer, Trace> traces;

  /**
   * Creates the records.
   *
   * @param records of all executed cases, by number
   * @param traces of all executed cases if the model has trajectory conditions
   */
  FaultyRecords(
      FaultExecutions executions, Map<Integer, CaseRecord> records, Map<Integer, Trace> traces) {
    this.executions = executions;
    this.records = records;
    this.traces = traces;
  }

  /**
   * One execution.
   *
   * @param trace null if the signals are not known
   */
  record Recorded(CaseRecord record, @Nullable Trace trace) {}

  /** The record of a case without a fault; empty if it was not executed. */
  Optional<Recorded> of(List<String> values) {
    int no = executions.number(values);
    CaseRecord record = no == 0 ? null : records.get(no);
    return record == null || record.outcome() == Outcome.NOT_CALLED
        ? Optional.empty()
        : Optional.of(new Recorded(record, traces.get(no)));
  }

  /** The record of a case with a fault; empty where it has no effect or was not executed. */
  Optional<Recorded> of(Fault fault, Row row) {
    Optional<Recorded> base = of(row.values());
    if (base.isEmpty()) {
      return Optional.empty();
    }
    Recorded without = base.get();
    if (fault instanceof Fault.OfInputs ofInputs) {
      return ofInputs
          .change()
          .apply(row.values(), row.before())
          .flatMap(this::of)
          .filter(
              changed ->
                  isChanged(without.record(), changed.record())
                      || signalsDiffer(without.trace(), changed.trace()));
    }
    @Nullable CaseRecord before =
        row.before() == null ? null : of(row.before()).map(Recorded::record).orElse(null);
    CaseRecord changed = ((Fault.OfRecord) fault).change().apply(row, without.record(), before);
    return isChanged(without.record(), changed)
        ? Optional.of(new Recorded(changed, without.trace()))
        : Optional.empty();
  }

  /** Whether a value differs; times and messages do not count. */
  private static boolean isChanged(CaseRecord one, CaseRecord other) {
    return one.outcome() != other.outcome()
        || !one.thrown().equals(other.thrown())
        || !one.actual().equals(other.actual())
        || !one.calls().equals(other.calls());
  }

  /** Whether the simulation went another way. */
  private static boolean signalsDiffer(@Nullable Trace one, @Nullable Trace other) {
    if (one == null || other == null || one.count() != other.count()) {
      return one != other;
    }
    for (int i = 0; i < one.columns().size(); i++) {
      if (!Arrays.equals(one.columns().get(i), other.columns().get(i))) {
        return true;
      }
    }
    return false;
  }
}
