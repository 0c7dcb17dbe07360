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
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/** Expected values from the records of a reference implementation. */
public final class ReferenceValues {
  private static final String ERROR = "!error:";
  private static final String UNEVALUATED = "!unevaluated: ";

  private ReferenceValues() {}

  /**
   * Adds what the reference returned, or the exception that it threw, as the expected value of each
   * output that has none. If the reference failed in another way, the case cannot be judged, and
   * its verdict is ERROR.
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
    boolean single = model.outputs().size() == 1;
    Set<String> known = new HashSet<>();
    List<ExpectedValue> expected = new ArrayList<>(testCase.expected());
    expected.forEach(e -> known.add(e.output()));
    for (OutputElement output : model.outputs()) {
      String name = single ? "" : output.name();
      if (!known.contains(name)) {
        expected.add(new ExpectedValue(name, literal(output, record)));
      }
    }
    return new TestCase(
        testCase.no(), testCase.valid(), testCase.values(), expected, testCase.steps());
  }

  private static String literal(OutputElement output, @Nullable CaseRecord record) {
    if (record == null) {
      return UNEVALUATED + "the reference did not execute this case";
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
