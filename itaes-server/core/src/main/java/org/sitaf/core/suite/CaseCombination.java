package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.CoveringArray;
import org.sitaf.core.combine.Interaction;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TestDataCombinator;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.MixedStrength;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestValue;

/**
 * Poses the values of a model as problems for the Test Data Combinator (TDC), and reads its rows
 * back as values.
 */
final class CaseCombination {
  private final TestModel model;
  private final List<TestData> data;
  private final Conditions conditions;
  private final Strength strength;
  private final GenerationOptions options;
  private final Diagnostics diagnostics;
  private final Progress progress;
  private final List<KeptCases.Kept> keptCases;
  private final List<List<TestValue>> kept;
  private final ImpossibleCombinations impossible;

  CaseCombination(
      TestModel model,
      List<TestData> data,
      Conditions conditions,
      Strength strength,
      GenerationOptions options,
      KeptCases keptCases,
      Progress progress,
      Diagnostics diagnostics) {
    this.model = model;
    this.data = data;
    this.conditions = conditions;
    this.strength = strength;
    this.options = options;
    this.diagnostics = diagnostics;
    this.progress = progress;
    this.impossible = new ImpossibleCombinations(model);
    this.keptCases = keptCases.all().stream().filter(this::isAllowed).toList();
    this.kept =
        this.keptCases.stream().filter(KeptCases.Kept::isComplete).map(this::keptRow).toList();
  }

  /** All values alike. */
  List<List<TestValue>> mixed() {
    List<List<TestValue>> candidates = data.stream().map(TestData::values).toList();
    Set<List<TestValue>> rows = new LinkedHashSet<>(kept);
    rows.addAll(combine(candidates, -1, null));
    impossible.tell(diagnostics);
    return List.copyOf(rows);
  }

  /**
   * First all t-tuples of valid values in wholly valid cases; then each invalid value with all
   * (t-1)-tuples of the others' valid values, so that one error cannot mask another.
   */
  List<List<TestValue>> isolated() {
    List<List<TestValue>> valid =
        data.stream().map(d -> d.values().stream().filter(TestValue::valid).toList()).toList();
    for (int p = 0; p < valid.size(); p++) {
      if (valid.get(p).isEmpty()) {
        diagnostics.error(
            model.source(),
            model.inputs().get(p).line(),
            "test_element " + model.inputs().get(p).name(),
            "has no valid value; every case would be invalid. Declare one, or set invalid_values to"
                + " combine");
      }
    }
    diagnostics.throwIfErrors();
    Set<List<TestValue>> rows = new LinkedHashSet<>(kept);
    rows.addAll(combine(valid, -1, true));
    for (int p = 0; p < data.size(); p++) {
      for (TestValue value : data.get(p).values()) {
        if (!value.valid()) {
          List<List<TestValue>> candidates = new ArrayList<>(valid);
          candidates.set(p, List.of(value));
          rows.addAll(combine(candidates, p, false));
        }
      }
    }
    impossible.tell(diagnostics);
    return List.copyOf(rows);
  }

  /**
   * What to cover; around a parameter that is held at one invalid value, one strength less among
   * the others.
   */
  private List<Interaction> interactions(int held) {
    List<Interaction> all = new ArrayList<>();
    int[] everything = IntStream.range(0, data.size()).toArray();
    add(all, strength, everything, held);
    for (MixedStrength mixed : model.mixedStrengths()) {
      int[] group =
          IntStream.range(0, data.size())
              .filter(i -> mixed.parameters().contains(model.inputs().get(i).name()))
              .toArray();
      if (held < 0 || IntStream.of(group).anyMatch(p -> p == held)) {
        add(all, mixed.strength(), group, held);
      }
    }
    return all;
  }

  private static void add(List<Interaction> all, Strength t, int[] parameters, int held) {
    int[] free = IntStream.of(parameters).filter(p -> p != held).toArray();
    int wanted = Math.min(t.t(), parameters.length) - (held < 0 ? 0 : 1);
    if (wanted > 0 && free.length > 0) {
      all.add(new Interaction(wanted, free));
    }
  }

  /**
   * The rows of one array.
   *
   * @param held the parameter that is held at its only, invalid, value; -1 where none is
   * @param valid whether all its cases are; null where they differ
   */
  private List<List<TestValue>> combine(
      List<List<TestValue>> candidates, int held, @Nullable Boolean valid) {
    int[] levels = candidates.stream().mapToInt(List::size).toArray();
    List<Interaction> interactions = interactions(held);
    List<int[]> seeds = seeds(candidates);
    if ((seeds.isEmpty() && IntStream.of(levels).allMatch(l -> l == 1)) || interactions.isEmpty()) {
      // Nothing varies, or no tuple is asked for: one case, whichever the conditions allow.
      seeds.add(IntStream.of(levels).map(l -> CombinationProblem.FREE).toArray());
    }
    List<Constraint> constraints =
        conditions.pre().stream().map(c -> constraint(c, candidates, valid)).toList();
    CoveringArray array =
        new TestDataCombinator()
            .combine(
                new CombinationProblem(levels, interactions, constraints, seeds),
                options.effort(),
                options.seed(),
                progress);
    impossible.add(array.tuples(), candidates, held);
    if (held >= 0 && array.size() == 0) {
      impossible.addValue(held, candidates);
    }
    for (int refused : array.refusedSeeds()) {
      tellRefused(seeds.get(refused), candidates);
    }
    List<List<TestValue>> rows = new ArrayList<>();
    for (int[] row : array.rows()) {
      rows.add(
          IntStream.range(0, row.length).mapToObj(p -> candidates.get(p).get(row[p])).toList());
    }
    return rows;
  }

  /**
   * The cases to keep that fit these candidates, as rows of indices; free where a case has no
   * value.
   */
  private List<int[]> seeds(List<List<TestValue>> candidates) {
    List<int[]> seeds = new ArrayList<>();
    for (KeptCases.Kept keptCase : keptCases) {
      int[] seed = new int[candidates.size()];
      boolean fits = true;
      for (int p = 0; p < seed.length; p++) {
        Value value = keptCase.values().get(p);
        // Where one invalid value is held, a case that does not name it belongs elsewhere.
        boolean mustBeNamed = candidates.get(p).size() == 1 && !candidates.get(p).get(0).valid();
        seed[p] = value == null ? CombinationProblem.FREE : indexOf(candidates.get(p), value);
        fits &= value == null ? !mustBeNamed : seed[p] >= 0;
      }
      if (fits) {
        seeds.add(seed);
      }
    }
    return seeds;
  }

  private static int indexOf(List<TestValue> candidates, Value value) {
    for (int i = 0; i < candidates.size(); i++) {
      if (candidates.get(i).value().equals(value)) {
        return i;
      }
    }
    return -1;
  }

  private Constraint constraint(
      Expression condition, List<List<TestValue>> candidates, @Nullable Boolean valid) {
    boolean dependsOnAll = valid == null && condition.mentions(Variables.VALID);
    int[] parameters =
        IntStream.range(0, candidates.size())
            .filter(p -> dependsOnAll || mentions(condition, model.inputs().get(p).name()))
            .toArray();
    return new Constraint(
        parameters,
        tuple -> {
          Variables variables = new Variables();
          boolean allValid = true;
          for (int i = 0; i < parameters.length; i++) {
            TestValue value = candidates.get(parameters[i]).get(tuple[i]);
            InputElement input = model.inputs().get(parameters[i]);
            variables.put(input.name(), value.value(), input.type());
            allValid &= value.valid();
          }
          variables.put(Variables.VALID, valid == null ? allValid : valid);
          return holds(condition, variables);
        });
  }

  private boolean holds(Expression condition, Variables variables) {
    try {
      return condition.isTrue(variables.map());
    } catch (EvaluationException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(),
                  0,
                  "pre_condition_spec_list",
                  "'"
                      + condition.text()
                      + "' has no value for "
                      + variables.map()
                      + ": "
                      + e.getMessage())));
    }
  }

  private static boolean mentions(Expression condition, String input) {
    return Variables.roots(List.of(input)).stream().anyMatch(condition::mentions);
  }

  private void tellRefused(int[] seed, List<List<TestValue>> candidates) {
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
          "the case with " + values + " that was to be kept is in no allowed case and is left out");
    }
  }

  /** Whether a kept case still keeps the conditions; one that lacks values may yet be completed. */
  private boolean isAllowed(KeptCases.Kept keptCase) {
    if (!keptCase.isComplete()) {
      return true;
    }
    List<TestValue> row = keptRow(keptCase);
    Variables variables = new Variables();
    for (int p = 0; p < row.size(); p++) {
      variables.put(model.inputs().get(p).name(), row.get(p).value(), model.inputs().get(p).type());
    }
    variables.put(Variables.VALID, row.stream().allMatch(TestValue::valid));
    Optional<Expression> broken =
        conditions.pre().stream().filter(c -> !holds(c, variables)).findFirst();
    broken.ifPresent(
        c ->
            diagnostics.warning(
                model.source(),
                0,
                "pre_condition_spec_list",
                "case "
                    + keptCase.no()
                    + " that was to be kept breaks '"
                    + c.text()
                    + "' and is left out; its number is not used again"));
    return broken.isEmpty();
  }

  /** A kept case stays as it is; a value that the model no longer gives does not count as valid. */
  private List<TestValue> keptRow(KeptCases.Kept keptCase) {
    return IntStream.range(0, data.size())
        .mapToObj(
            p -> {
              Value value = Objects.requireNonNull(keptCase.values().get(p));
              int index = indexOf(data.get(p).values(), value);
              return index >= 0 ? data.get(p).values().get(index) : new TestValue(value, false);
            })
        .toList();
  }
}
