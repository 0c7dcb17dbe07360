package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;

/** The faults of outputs and exceptions. */
public final class OutputFaults {
  /** Name of the exception that faults throw. */
  static final String INJECTED = "InjectedFault";

  /** What a fault of exceptions changes. */
  static final String EXCEPTION = "exception";

  private final TestModel model;
  private final String unit;
  private final List<Fault> faults = new ArrayList<>();

  private OutputFaults(TestModel model, String unit) {
    this.model = model;
    this.unit = unit;
  }

  /**
   * All faults of the outputs of a model.
   *
   * @param conditions under which a clearly wrong value is tried, too
   */
  public static List<Fault> of(TestModel model, List<Condition> conditions) {
    return of(model, conditions, "case");
  }

  /**
   * All faults of the outputs of a model.
   *
   * @param unit what a record belongs to: {@code case} or {@code call}
   */
  public static List<Fault> of(TestModel model, List<Condition> conditions, String unit) {
    OutputFaults all = new OutputFaults(model, unit);
    for (OutputElement output : model.outputs()) {
      if (!output.type().isVoid()) {
        all.ofOutput(output);
      }
    }
    all.ofExceptions();
    conditions.forEach(all::under);
    return all.faults;
  }

  /** Clearly wrong values and exceptions under a condition. */
  public static List<Fault> under(TestModel model, Condition condition) {
    OutputFaults all = new OutputFaults(model, "");
    all.under(condition);
    return all.faults;
  }

  private void ofOutput(OutputElement output) {
    for (ValueChange change : ValueChanges.of(output.type())) {
      add(
          output,
          change.text(),
          (row, record, before) ->
              replaced(record, output.name(), change.apply(value(record, output.name()))));
    }
    String zero = ValueChanges.zero(output.type());
    if (!(output.type() instanceof DataType.Scalar)) {
      add(
          output,
          "never set, always " + zero,
          (row, record, before) -> replaced(record, output.name(), zero));
    }
    add(
        output,
        "value of the " + unit + " before",
        (row, record, before) ->
            before == null || !has(before, output.name())
                ? record
                : replaced(record, output.name(), value(before, output.name())));
  }

  private void ofExceptions() {
    faults.add(
        new Fault.OfRecord(
            EXCEPTION,
            EXCEPTION + ": thrown instead of a result",
            (row, record, before) -> thrown(record)));
    faults.add(
        new Fault.OfRecord(
            EXCEPTION,
            EXCEPTION + ": swallowed, the outputs are never set",
            (row, record, before) -> swallowed(record, null)));
    faults.add(
        new Fault.OfRecord(
            EXCEPTION,
            EXCEPTION + ": swallowed, the outputs keep the values of the " + unit + " before",
            (row, record, before) ->
                before == null || before.outcome() != Outcome.RETURNED
                    ? record
                    : swallowed(record, before)));
    faults.add(
        new Fault.OfRecord(
            EXCEPTION,
            EXCEPTION + ": of another type",
            (row, record, before) ->
                record.outcome() == Outcome.THREW ? with(record, INJECTED) : record));
  }

  private void under(Condition condition) {
    for (OutputElement output : model.outputs()) {
      if (output.type().isVoid()) {
        continue;
      }
      add(
          output,
          "wrong value " + condition.text(),
          (row, record, before) ->
              condition.holds().test(row.values())
                  ? replaced(
                      record,
                      output.name(),
                      ValueChanges.wrong(value(record, output.name()), output.type()))
                  : record);
      if (condition.single()) {
        String zero = ValueChanges.zero(output.type());
        add(
            output,
            zero + " " + condition.text(),
            (row, record, before) ->
                condition.holds().test(row.values())
                    ? replaced(record, output.name(), zero)
                    : record);
      }
    }
    faults.add(
        new Fault.OfRecord(
            EXCEPTION,
            EXCEPTION + ": thrown or swallowed " + condition.text(),
            (row, record, before) -> {
              if (!condition.holds().test(row.values())) {
                return record;
              }
              return record.outcome() == Outcome.THREW ? swallowed(record, null) : thrown(record);
            }));
  }

  private void add(OutputElement output, String text, Fault.RecordChange change) {
    faults.add(
        new Fault.OfRecord(
            output.name(),
            output.name() + ": " + text,
            (row, record, before) ->
                record.outcome() == Outcome.RETURNED && has(record, output.name())
                    ? change.apply(row, record, before)
                    : record));
  }

  private static boolean has(CaseRecord record, String output) {
    return record.actual().stream().anyMatch(a -> a.output().equals(output));
  }

  private static String value(CaseRecord record, String output) {
    return record.actual().stream()
        .filter(a -> a.output().equals(output))
        .map(NamedValue::literal)
        .findFirst()
        .orElse("");
  }

  private static CaseRecord replaced(CaseRecord record, String output, String literal) {
    if (value(record, output).equals(literal)) {
      return record;
    }
    return returned(
        record,
        record.actual().stream()
            .map(a -> a.output().equals(output) ? new NamedValue(output, literal) : a)
            .toList());
  }

  private static CaseRecord thrown(CaseRecord record) {
    return record.outcome() == Outcome.RETURNED ? with(record, INJECTED) : record;
  }

  private static CaseRecord with(CaseRecord record, String exception) {
    return new CaseRecord(
        record.no(), Outcome.THREW, exception, List.of(), record.calls(), record.time(), exception);
  }

  private CaseRecord swallowed(CaseRecord record, @Nullable CaseRecord before) {
    if (record.outcome() != Outcome.THREW) {
      return record;
    }
    List<NamedValue> values = new ArrayList<>();
    for (OutputElement output : model.outputs()) {
      Optional<String> kept =
          before == null || !has(before, output.name())
              ? Optional.empty()
              : Optional.of(value(before, output.name()));
      values.add(
          new NamedValue(output.name(), kept.orElseGet(() -> ValueChanges.zero(output.type()))));
    }
    return returned(record, values);
  }

  private static CaseRecord returned(CaseRecord record, List<NamedValue> values) {
    return new CaseRecord(
        record.no(), Outcome.RETURNED, "", values, record.calls(), record.time(), "");
  }
}
