package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/** Converts kept cases to rows of a suite, and to seeds of the combinator. */
final class KeptRows {
  private final TestModel model;
  private final List<TestData> data;
  private final List<Expression> preConditions;
  private final ConditionConstraints constraints;
  private final RelatedInputs related;
  private final Diagnostics diagnostics;
  private final List<KeptCases.Kept> keptCases;

  /** For each fixed parameter, the kept cases by its value. */
  private final Map<Integer, Map<Value, List<KeptCases.Kept>>> byValue = new HashMap<>();

  /** The index of each value in a list of candidates. Only used for kept cases. */
  private final Map<List<TestValue>, Map<Value, Integer>> indices = new IdentityHashMap<>();

  KeptRows(
      TestModel model,
      List<TestData> data,
      KeptCases keptCases,
      List<Expression> preConditions,
      ConditionConstraints constraints,
      RelatedInputs related,
      Diagnostics diagnostics) {
    this.model = model;
    this.data = data;
    this.preConditions = preConditions;
    this.constraints = constraints;
    this.related = related;
    this.diagnostics = diagnostics;
    this.keptCases = keptCases.all().stream().filter(this::isAllowed).toList();
  }

  /** The complete kept cases. */
  List<List<TestValue>> rows() {
    return keptCases.stream().filter(KeptCases.Kept::isComplete).map(this::row).toList();
  }

  /** The kept cases that match a part, as rows of indices; free if a case has no value. */
  List<int[]> seeds(CasePart part) {
    List<List<TestValue>> candidates = part.candidates();
    List<int[]> seeds = new ArrayList<>();
    for (KeptCases.Kept keptCase : matching(part)) {
      int[] seed = new int[candidates.size()];
      boolean fits = true;
      for (int p = 0; p < seed.length; p++) {
        Value value = keptCase.values().get(p);
        // With a fixed invalid value, a case must contain this value.
        boolean mustBeNamed = candidates.get(p).size() == 1 && !candidates.get(p).get(0).valid();
        seed[p] = value == null ? CombinationProblem.FREE : indexOf(candidates, p, keptCase);
        fits &= value == null ? !mustBeNamed : seed[p] >= 0;
      }
      if (fits) {
        seeds.add(seed);
      }
    }
    return seeds;
  }

  /** Reports a kept case that the conditions exclude. */
  void reportDropped(int[] seed, List<List<TestValue>> candidates) {
    String values =
        IntStream.range(0, seed.length)
            .filter(p -> seed[p] != CombinationProblem.FREE)
            .mapToObj(
                p ->
                    model.inputs().get(p).name()
                        + "="
                        + candidates.get(p).get(seed[p]).value().literal())
            .collect(Collectors.joining(", "));
    if (!values.isEmpty()) {
      diagnostics.warning(
          model.source(),
          0,
          "pre_condition_spec_list",
          "the kept case with " + values + " violates the conditions and is dropped");
    }
  }

  /** The kept cases that can match: with a fixed parameter, those with its value. */
  private List<KeptCases.Kept> matching(CasePart part) {
    int held = part.held();
    if (held < 0 || keptCases.isEmpty()) {
      return keptCases;
    }
    return byValue
        .computeIfAbsent(
            held,
            p ->
                keptCases.stream()
                    .filter(k -> k.values().get(p) != null)
                    .collect(Collectors.groupingBy(k -> Objects.requireNonNull(k.values().get(p)))))
        .getOrDefault(part.heldValue().value(), List.of());
  }

  private int indexOf(List<List<TestValue>> candidates, int p, KeptCases.Kept keptCase) {
    List<TestValue> values = candidates.get(p);
    Value value = Objects.requireNonNull(keptCase.values().get(p));
    int found =
        values.size() == 1 && values.get(0).relation() == null
            ? values.get(0).value().equals(value) ? 0 : -1
            : indices.computeIfAbsent(values, KeptRows::index).getOrDefault(value, -1);
    for (int i = 0; found < 0 && i < values.size(); i++) {
      if (values.get(i).relation() != null && follows(values.get(i), p, keptCase)) {
        found = i;
      }
    }
    return found;
  }

  /** Whether a related value gives the value of a kept case. */
  private boolean follows(TestValue candidate, int p, KeptCases.Kept keptCase) {
    for (int input : related.withFollowed(p)) {
      if (keptCase.values().get(input) == null) {
        return false;
      }
    }
    IntFunction<TestValue> values =
        q ->
            q == p
                ? candidate
                : new TestValue(Objects.requireNonNull(keptCase.values().get(q)), true);
    return related.resolve(p, values).equals(Optional.ofNullable(keptCase.values().get(p)));
  }

  private static Map<Value, Integer> index(List<TestValue> candidates) {
    Map<Value, Integer> index = new HashMap<>();
    for (int i = 0; i < candidates.size(); i++) {
      if (candidates.get(i).relation() == null) {
        index.putIfAbsent(candidates.get(i).value(), i);
      }
    }
    return index;
  }

  /**
   * Whether a kept case satisfies the conditions. Incomplete cases are checked when they are
   * completed.
   */
  private boolean isAllowed(KeptCases.Kept keptCase) {
    if (!keptCase.isComplete()) {
      return true;
    }
    Variables variables = CaseVariables.of(model, row(keptCase));
    Optional<Expression> broken =
        preConditions.stream().filter(c -> !constraints.holds(c, variables)).findFirst();
    broken.ifPresent(
        c ->
            diagnostics.warning(
                model.source(),
                constraints.line(c),
                "pre_condition_spec_list",
                "case "
                    + keptCase.no()
                    + " violates '"
                    + c.text()
                    + "' and is dropped; its number is not reused"));
    return broken.isEmpty();
  }

  /**
   * The values of a kept case. A value that the model does not generate is valid if it lies in the
   * classes of its element.
   */
  private List<TestValue> row(KeptCases.Kept keptCase) {
    List<List<TestValue>> all = data.stream().map(TestData::values).toList();
    return IntStream.range(0, data.size())
        .mapToObj(
            p -> {
              Value value = Objects.requireNonNull(keptCase.values().get(p));
              int index = indexOf(all, p, keptCase);
              return index < 0
                  ? new TestValue(
                      value, TestDataGenerator.isInClasses(model.inputs().get(p), value))
                  : new TestValue(value, all.get(p).get(index).valid());
            })
        .toList();
  }
}
