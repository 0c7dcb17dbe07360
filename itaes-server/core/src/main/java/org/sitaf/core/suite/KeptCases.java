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
 * The cases to keep: those of the model's {@code case_list} and those of an earlier suite. A case
 * with a value for every element keeps its number. A case that lacks a value is completed and gets
 * a new number, since it is a different case now.
 */
final class KeptCases {
  private final List<Kept> cases;
  private final Map<List<Value>, Kept> byValues = new HashMap<>();
  private final int highestNumber;

  /**
   * A case to keep.
   *
   * @param no case number; 0 if it has none
   * @param values values in the order of the model's inputs; null if a value is missing
   * @param expected expected values of the earlier suite
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

  /**
   * Collects the cases of a model and an earlier suite. Cases that do not match the model are
   * reported.
   */
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
                + " case(s) lack a value for a new element; they are completed and get new"
                + " numbers");
      }
    }
    return new KeptCases(cases, highest);
  }

  List<Kept> all() {
    return cases;
  }

  /** The kept case with these values and a number. */
  Optional<Kept> numbered(List<Value> values) {
    return Optional.ofNullable(byValues.get(values)).filter(k -> k.no() > 0);
  }

  /** New cases must have higher numbers. */
  int highestNumber() {
    return highestNumber;
  }

  /** The position of each input in the cases of a suite; -1 if missing. */
  private static int[] positions(TestModel model, TestSuite earlier, Diagnostics diagnostics) {
    List<String> names = earlier.parameters().stream().map(CaseParameter::name).toList();
    for (String name : names) {
      if (model.inputs().stream().noneMatch(i -> i.name().equals(name))) {
        diagnostics.warning(
            earlier.name(),
            0,
            "param " + name,
            "is no longer an element of the model; its values are dropped");
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
