package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.suite.SuiteView.CaseView;

/**
 * The differences between a suite and the previous suite of the same model. Cases are matched by
 * their values.
 */
@Schema(name = "SuiteChanges")
record ChangesView(
    @Schema(description = "the previous suite; absent for the first one")
        @Nullable String previousId,
    @Schema(description = "whether the parameters differ, so that cases cannot be compared")
        boolean otherParameters,
    int kept,
    int added,
    int removed,
    @Schema(description = "cases whose expected values changed") int expectedChanged,
    @Schema(description = "the first 300 cases that were added, removed or changed")
        List<ChangeView> items) {
  private static final int MAX_ITEMS = 300;

  enum Change {
    added,
    removed,
    expected
  }

  @Schema(name = "CaseChange")
  record ChangeView(Change change, @Nullable CaseView before, @Nullable CaseView now) {}

  static ChangesView first() {
    return new ChangesView(null, false, 0, 0, 0, 0, List.of());
  }

  static ChangesView between(String previousId, TestSuite before, TestSuite now) {
    if (!names(before).equals(names(now))) {
      return new ChangesView(previousId, true, 0, 0, 0, 0, List.of());
    }
    Map<TestCase, TestCase> remaining = new HashMap<>();
    before.cases().forEach(c -> remaining.put(inputs(c), c));
    List<ChangeView> items = new ArrayList<>();
    int kept = 0;
    int added = 0;
    int changed = 0;
    for (TestCase testCase : now.cases()) {
      TestCase previous = remaining.remove(inputs(testCase));
      if (previous == null) {
        added++;
        add(items, new ChangeView(Change.added, null, CaseView.of(testCase, now)));
      } else if (!expected(previous).equals(expected(testCase))) {
        changed++;
        add(
            items,
            new ChangeView(
                Change.expected, CaseView.of(previous, before), CaseView.of(testCase, now)));
      } else {
        kept++;
      }
    }
    int removed = 0;
    for (TestCase testCase : before.cases()) {
      if (remaining.get(inputs(testCase)) == testCase) {
        removed++;
        add(items, new ChangeView(Change.removed, CaseView.of(testCase, before), null));
      }
    }
    return new ChangesView(previousId, false, kept, added, removed, changed, items);
  }

  /** What a case does, without its number, class and expected values. */
  private static TestCase inputs(TestCase testCase) {
    return new TestCase(
        1,
        true,
        testCase.values(),
        List.of(),
        testCase.steps().stream()
            .map(step -> new TestStep(step.name(), true, step.values(), List.of()))
            .toList());
  }

  /** The expected values of a case, and of each of its steps. */
  private static List<List<ExpectedValue>> expected(TestCase testCase) {
    List<List<ExpectedValue>> expected = new ArrayList<>(List.of(testCase.expected()));
    testCase.steps().forEach(step -> expected.add(step.expected()));
    return expected;
  }

  /** The parameters of the cases, and of each kind of step. */
  private static List<List<String>> names(TestSuite suite) {
    List<List<String>> names = new ArrayList<>();
    names.add(suite.parameters().stream().map(CaseParameter::name).toList());
    suite
        .stepParameters()
        .forEach(
            s -> names.add(s.parameters().stream().map(p -> s.name() + "." + p.name()).toList()));
    return names;
  }

  private static void add(List<ChangeView> items, ChangeView item) {
    if (items.size() < MAX_ITEMS) {
      items.add(item);
    }
  }
}
