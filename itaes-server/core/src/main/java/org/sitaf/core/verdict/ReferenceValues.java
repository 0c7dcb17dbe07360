package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

/** Expected values from the records of a reference implementation. */
public final class ReferenceValues {
  private static final String ERROR = "!error:";
  private static final String UNEVALUATED = "!unevaluated: ";

  private ReferenceValues() {}

  /**
   * Adds what the reference returned, or the exception that it threw, as the expected value of each
   * output that has none, in a sequence for each step. If the reference failed in another way, the
   * case or step cannot be judged, and its verdict is ERROR.
   *
   * @param records of the reference, at most one for each case
   */
  public static TestSuite added(TestModel model, TestSuite suite, List<CaseRecord> records) {
    Map<Integer, CaseRecord> byNumber = new HashMap<>();
    records.forEach(record -> byNumber.put(record.no(), record));
    return suite.withCases(
        suite.cases().stream().map(c -> added(model, c, byNumber.get(c.no()))).toList());
  }

  private static TestCase added(TestModel model, TestCase testCase, @Nullable CaseRecord record) {
    List<TestStep> steps = new ArrayList<>();
    for (int i = 0; i < testCase.steps().size(); i++) {
      steps.add(added(model, testCase.steps().get(i), step(record, i)));
    }
    return new TestCase(
        testCase.no(),
        testCase.valid(),
        testCase.values(),
        steps.isEmpty() ? added(model.outputs(), testCase.expected(), record) : testCase.expected(),
        steps);
  }

  /** The record of a step; that of the case if it ended before. */
  private static @Nullable CaseRecord step(@Nullable CaseRecord record, int index) {
    return record != null && index < record.steps().size()
        ? record.steps().get(index).record()
        : record != null && record.outcome() == CaseRecord.Outcome.ERROR ? record : null;
  }

  /** Nothing is added to an event or to a call that must end with an error. */
  private static TestStep added(TestModel model, TestStep step, @Nullable CaseRecord record) {
    SequenceSpec sequence = model.sequence();
    List<OutputElement> outputs =
        sequence == null
            ? List.of()
            : sequence.call(step.name()).map(c -> c.model().outputs()).orElse(List.of());
    boolean ends = step.expected().stream().anyMatch(e -> Value.isOutcome(e.literal()));
    return ends
        ? step
        : new TestStep(
            step.name(), step.valid(), step.values(), added(outputs, step.expected(), record));
  }

  private static List<ExpectedValue> added(
      List<OutputElement> outputs, List<ExpectedValue> given, @Nullable CaseRecord record) {
    boolean single = outputs.size() == 1;
    Set<String> known = new HashSet<>();
    List<ExpectedValue> expected = new ArrayList<>(given);
    expected.forEach(e -> known.add(e.output()));
    for (OutputElement output : outputs) {
      String name = single ? "" : output.name();
      if (!known.contains(name)) {
        expected.add(new ExpectedValue(name, literal(output, record)));
      }
    }
    return expected;
  }

  private static String literal(OutputElement output, @Nullable CaseRecord record) {
    if (record == null) {
      return UNEVALUATED + "the reference did not execute it";
    }
    return switch (record.outcome()) {
      case RETURNED ->
          record.actual().stream()
              .filter(actual -> actual.output().equals(output.name()))
              .map(NamedValue::literal)
              .findFirst()
              .orElse(UNEVALUATED + "the reference recorded no value of " + output.name());
      case THREW -> ERROR + record.thrown();
      case ERROR, NOT_CALLED -> UNEVALUATED + "the reference failed: " + record.message();
    };
  }
}
