package org.sitaf.core.score.fault;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseRecord;

/** A fault between driver and component. */
public sealed interface Fault {

  /** The output, input or required method that it changes. */
  String where();

  /** The fault in words, such as {@code return: radians taken for degrees}. */
  String text();

  /** A fault of what the component returns, throws or calls; changes records. */
  record OfRecord(String where, String text, RecordChange change) implements Fault {
    public OfRecord {
      Objects.requireNonNull(where);
      Objects.requireNonNull(text);
      Objects.requireNonNull(change);
    }
  }

  /** A fault of what the component receives; the changed case is executed. */
  record OfInputs(String where, String text, RowChange change) implements Fault {
    public OfInputs {
      Objects.requireNonNull(where);
      Objects.requireNonNull(text);
      Objects.requireNonNull(change);
    }
  }

  /** Changes what was recorded of a case. */
  @FunctionalInterface
  interface RecordChange {
    /**
     * The record with the fault; the same record where it has no effect.
     *
     * @param row the values of the case
     * @param before the record of the case before; null for the first one
     */
    CaseRecord apply(Row row, CaseRecord record, @Nullable CaseRecord before);
  }

  /** Changes the values of a case. */
  @FunctionalInterface
  interface RowChange {
    /**
     * The values that the component receives; empty where the fault cannot occur.
     *
     * @param before the values of the case before; null for the first one
     */
    Optional<List<String>> apply(List<String> values, @Nullable List<String> before);
  }
}
