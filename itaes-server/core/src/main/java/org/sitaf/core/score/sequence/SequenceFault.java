package org.sitaf.core.score.sequence;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.verdict.StepRecord;

/** A fault between driver and component while a sequence is executed. */
sealed interface SequenceFault {

  /** The step, or its output, input or required method. */
  String where();

  /** The fault in words, such as {@code Enable: left out}. */
  String text();

  /** A fault of what the component returns, throws or calls; changes the records of steps. */
  record OfRecords(String where, String text, RecordsChange change) implements SequenceFault {
    public OfRecords {
      Objects.requireNonNull(where);
      Objects.requireNonNull(text);
      Objects.requireNonNull(change);
    }
  }

  /** A fault of what reaches the component, and in which order; the changed case is executed. */
  record OfSteps(String where, String text, StepsChange change) implements SequenceFault {
    public OfSteps {
      Objects.requireNonNull(where);
      Objects.requireNonNull(text);
      Objects.requireNonNull(change);
    }
  }

  /** Changes what was recorded of the steps of a case. */
  @FunctionalInterface
  interface RecordsChange {
    /** The records with the fault; the same records where it has no effect. */
    List<StepRecord> apply(TestCase testCase, List<StepRecord> records);
  }

  /** Changes the steps of a case. */
  @FunctionalInterface
  interface StepsChange {
    /**
     * What reaches the component; empty where the fault cannot occur.
     *
     * @param before the case before in the suite; null if there is none
     */
    Optional<Delivery> apply(TestCase testCase, @Nullable TestCase before);
  }
}
