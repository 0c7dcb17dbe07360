package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;

/**
 * The cases that a user already has: those of the model's {@code case_list} and those of an earlier
 * suite. A case that still has a value for every element stays under its number; one that lacks
 * some is completed and gets a new number, since it means something else now.
 */
final class KeptCases {
  private final List<Kept> cases;
  private final Map<List<Value>, Kept> byValues = new HashMap<>();
  private final int highestNumber;

  /**
   * A case to keep.
   *
   * @param no 0 where it has no number yet
   * @param values in the order of the model's inputs; null where it has none for an element
   * @param expected of the earlier suite
   */
  record Kept(int no, List<@Nullable Value> values, List<ExpectedValue> expected) {
    Kept {
      values = Collections.unmodifiableList(new ArrayList<>(values));
      expected = List.copyOf(expected);
    }

    boolean isComplete() {
      return values.stream().allMatch(Objects::nonNull);
    }
  }

  private KeptCases(List<Kept> cases, int highestNumber) {
    this.cases = List.copyOf(cases);
    this.highestNumber = highestNumber;
    for (Kept kept : cases) {
      if (kept.isComplete()) {
        byValues.putIfAbsent(new ArrayList<>(kept.values()), kept);
      }
    }
  }

  /** All cases to keep of a model and of an earlier suite of it; what does not fit is told. */
  static KeptCases of(TestModel model, @Nullable TestSuite earlier, Diagnostics diagnostics) {
    List<Kept> cases = new ArrayList<>();
    int highest = 0;
    for (KeptCase kept : model.keptCases()) {
      cases.add(new Kept(kept.no(), List.copyOf(kept.values()), List.of()));
      highest = Math.max(highest, kept.no());
    }
    if (earlier != null) {
      int[] positions = positions(model, earlier, diagnostics);
      int completed = 0;
      for (TestCase testCase : earlier.cases()) {
        highest = Math.max(highest, testCase.no());
        @Nullable Value[] values = new @Nullable Value[model.inputs().size()];
        for (int p = 0; p < positions.length; p++) {
          if (positions[p] >= 0) {
            values[p] =
                value(
                    testCase.values().get(positions[p]),
                    model.inputs().get(p),
                    "case " + testCase.no(),
                    earlier.name(),
                    diagnostics);
          }
        }
        Kept kept = new Kept(testCase.no(), Arrays.asList(values), testCase.expected());
        completed += kept.isComplete() ? 0 : 1;
        cases.add(kept);
      }
      if (completed > 0) {
        diagnostics.warning(
            earlier.name(),
            0,
            "case_list",
            completed
                + " case(s) lack a value for a new element; they are completed and numbered anew");
      }
    }
    return new KeptCases(cases, highest);
  }

  List<Kept> all() {
    return cases;
  }

  /** The case of these values that keeps its number. */
  Optional<Kept> numbered(List<Value> values) {
    return Optional.ofNullable(byValues.get(values)).filter(k -> k.no() > 0);
  }

  /** No case that is new may get a number up to this one. */
  int highestNumber() {
    return highestNumber;
  }

  /** Where the values of each input stand in the cases of a suite; -1 where they do not. */
  private static int[] positions(TestModel model, TestSuite earlier, Diagnostics diagnostics) {
    List<String> names = earlier.parameters().stream().map(CaseParameter::name).toList();
    for (String name : names) {
      if (model.inputs().stream().noneMatch(i -> i.name().equals(name))) {
        diagnostics.warning(
            earlier.name(),
            0,
            "param " + name,
            "is no element of the model any more; its values are dropped");
      }
    }
    return model.inputs().stream().mapToInt(i -> names.indexOf(i.name())).toArray();
  }

  private static @Nullable Value value(
      String literal, InputElement input, String where, String suite, Diagnostics diagnostics) {
    try {
      return input.kind() == InputKind.TDTS
          ? Value.parseAnswer(literal, input.type())
          : Value.parse(literal, input.type());
    } catch (IllegalArgumentException e) {
      diagnostics.error(suite, 0, where + "/" + input.name(), String.valueOf(e.getMessage()));
      return null;
    }
  }
}
