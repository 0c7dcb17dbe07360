package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
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
    Map<List<String>, TestCase> remaining = new HashMap<>();
    before.cases().forEach(c -> remaining.put(c.values(), c));
    List<ChangeView> items = new ArrayList<>();
    int kept = 0;
    int added = 0;
    int changed = 0;
    for (TestCase testCase : now.cases()) {
      TestCase previous = remaining.remove(testCase.values());
      if (previous == null) {
        added++;
        add(items, new ChangeView(Change.added, null, CaseView.of(testCase)));
      } else if (!previous.expected().equals(testCase.expected())) {
        changed++;
        add(items, new ChangeView(Change.expected, CaseView.of(previous), CaseView.of(testCase)));
      } else {
        kept++;
      }
    }
    int removed = 0;
    for (TestCase testCase : before.cases()) {
      if (remaining.get(testCase.values()) == testCase) {
        removed++;
        add(items, new ChangeView(Change.removed, CaseView.of(testCase), null));
      }
    }
    return new ChangesView(previousId, false, kept, added, removed, changed, items);
  }

  private static List<String> names(TestSuite suite) {
    return suite.parameters().stream().map(CaseParameter::name).toList();
  }

  private static void add(List<ChangeView> items, ChangeView item) {
    if (items.size() < MAX_ITEMS) {
      items.add(item);
    }
  }
}
