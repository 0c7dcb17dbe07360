package org.sitaf.core.suite;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.MixedStrength;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestValue;

/**
 * Converts a test model to problems of the Test Data Combinator (TDC), and the resulting rows to
 * test values.
 */
final class CaseCombination {
  /** Maximum number of cases of a suite. */
  private static final int MAX_CASES = 1_000_000;

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
  private final ConditionConstraints constraints;

  /** For each fixed parameter, the kept cases by its value. */
  private final Map<Integer, Map<Value, List<KeptCases.Kept>>> keptByValue = new HashMap<>();

  /** The index of each value in a list of candidates. Only used for kept cases. */
  private final Map<List<TestValue>, Map<Value, Integer>> indices = new IdentityHashMap<>();

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
    this.constraints = new ConditionConstraints(model, conditions.pre());
    this.keptCases = keptCases.all().stream().filter(this::isAllowed).toList();
    this.kept =
        this.keptCases.stream().filter(KeptCases.Kept::isComplete).map(this::keptRow).toList();
  }

  /** Combines valid and invalid values alike. */
  List<List<TestValue>> mixed() {
    List<List<TestValue>> candidates = data.stream().map(TestData::values).toList();
    Set<List<TestValue>> rows = new LinkedHashSet<>(kept);
    rows.addAll(combine(candidates, -1, null));
    impossible.report(diagnostics);
    return List.copyOf(rows);
  }

  /**
   * Combines all t-tuples of valid values in valid cases, and each invalid value with all
   * (t-1)-tuples of valid values of the other parameters. One error can then not mask another.
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
            "has no valid value, so every case would be invalid; add a valid value or set"
                + " invalid_values to combine");
      }
    }
    diagnostics.throwIfErrors();
    checkSize(valid);
    Set<List<TestValue>> rows = new LinkedHashSet<>(kept);
    rows.addAll(combine(valid, -1, true));
    for (int p = 0; p < data.size(); p++) {
      for (TestValue value : data.get(p).values()) {
        if (!value.valid()) {
          List<List<TestValue>> candidates = new ArrayList<>(valid);
          candidates.set(p, List.of(value));
          rows.addAll(combine(candidates, p, false));
          if (rows.size() > MAX_CASES) {
            throw tooMany("more than " + MAX_CASES);
          }
        }
      }
    }
    impossible.report(diagnostics);
    return List.copyOf(rows);
  }

  /**
   * Rejects models that need too many cases. Models with pre-conditions may need fewer cases and
   * are not checked here.
   */
  private void checkSize(List<List<TestValue>> valid) {
    if (!conditions.pre().isEmpty()) {
      return;
    }
    int[] levels = valid.stream().mapToInt(List::size).toArray();
    BigInteger cases = atLeast(levels, strength.t(), -1);
    for (int p = 0; p < levels.length; p++) {
      long invalid = data.get(p).values().size() - levels[p];
      cases = cases.add(BigInteger.valueOf(invalid).multiply(atLeast(levels, strength.t() - 1, p)));
    }
    if (cases.compareTo(BigInteger.valueOf(MAX_CASES)) > 0) {
      throw tooMany(String.format(Locale.ROOT, "at least %,d", cases));
    }
  }

  /** The product of the largest levels, without those of one parameter. */
  private static BigInteger atLeast(int[] levels, int strength, int but) {
    return IntStream.range(0, levels.length)
        .filter(p -> p != but)
        .map(p -> -levels[p])
        .sorted()
        .limit(Math.max(0, strength))
        .mapToObj(n -> BigInteger.valueOf(-n))
        .reduce(BigInteger.ONE, BigInteger::multiply);
  }

  private InvalidInputException tooMany(String count) {
    return new InvalidInputException(
        List.of(
            Diagnostic.error(
                model.source(),
                0,
                "order_of_combinations",
                String.format(
                    Locale.ROOT,
                    "results in %s cases, but at most %,d can be generated; reduce the strength or"
                        + " the number of values",
                    count,
                    MAX_CASES))));
  }

  /** The line of the condition of a constraint; 0 if unknown. */
  int line(Constraint constraint) {
    return constraints.line(constraint);
  }

  /** The source text of the condition of a constraint. */
  String text(Constraint constraint) {
    return constraints.text(constraint);
  }

  /**
   * The interactions to cover. If a parameter is fixed to an invalid value, the strength among the
   * other parameters is one less.
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
   * Generates the rows of one covering array.
   *
   * @param held index of the parameter that is fixed to an invalid value; -1 if there is none
   * @param valid whether all cases are valid or invalid; null if they differ
   */
  private List<List<TestValue>> combine(
      List<List<TestValue>> candidates, int held, @Nullable Boolean valid) {
    int[] levels = candidates.stream().mapToInt(List::size).toArray();
    List<Interaction> interactions = interactions(held);
    List<int[]> seeds = seeds(candidates, held);
    if ((seeds.isEmpty() && IntStream.of(levels).allMatch(l -> l == 1)) || interactions.isEmpty()) {
      // Nothing varies or no tuples are required: generate any one allowed case.
      seeds.add(IntStream.of(levels).map(l -> CombinationProblem.FREE).toArray());
    }
    List<Constraint> conditionConstraints = constraints.constraints(candidates, valid);
    CoveringArray array =
        new TestDataCombinator()
            .combine(
                new CombinationProblem(levels, interactions, conditionConstraints, seeds),
                options.effort(),
                options.seed(),
                progress);
    impossible.add(array.tuples(), candidates, held);
    if (held >= 0 && array.size() == 0) {
      impossible.addValue(held, candidates);
    }
    for (int rejected : array.rejectedSeeds()) {
      reportDropped(seeds.get(rejected), candidates);
    }
    List<List<TestValue>> rows = new ArrayList<>();
    for (int[] row : array.rows()) {
      rows.add(
          IntStream.range(0, row.length).mapToObj(p -> candidates.get(p).get(row[p])).toList());
    }
    return rows;
  }

  /** The kept cases that match the candidates, as rows of indices; free if a case has no value. */
  private List<int[]> seeds(List<List<TestValue>> candidates, int held) {
    List<int[]> seeds = new ArrayList<>();
    for (KeptCases.Kept keptCase : keptCases(candidates, held)) {
      int[] seed = new int[candidates.size()];
      boolean fits = true;
      for (int p = 0; p < seed.length; p++) {
        Value value = keptCase.values().get(p);
        // With a fixed invalid value, a case must contain this value.
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

  /** The kept cases that can match: with a fixed parameter, those with its value. */
  private List<KeptCases.Kept> keptCases(List<List<TestValue>> candidates, int held) {
    if (held < 0 || keptCases.isEmpty()) {
      return keptCases;
    }
    Map<Value, List<KeptCases.Kept>> byValue =
        keptByValue.computeIfAbsent(
            held,
            p ->
                keptCases.stream()
                    .filter(k -> k.values().get(p) != null)
                    .collect(
                        Collectors.groupingBy(k -> Objects.requireNonNull(k.values().get(p)))));
    return byValue.getOrDefault(candidates.get(held).get(0).value(), List.of());
  }

  private int indexOf(List<TestValue> candidates, Value value) {
    if (candidates.size() == 1) {
      return candidates.get(0).value().equals(value) ? 0 : -1;
    }
    return indices.computeIfAbsent(candidates, CaseCombination::index).getOrDefault(value, -1);
  }

  private static Map<Value, Integer> index(List<TestValue> candidates) {
    Map<Value, Integer> index = new HashMap<>();
    for (int i = 0; i < candidates.size(); i++) {
      index.putIfAbsent(candidates.get(i).value(), i);
    }
    return index;
  }

  private void reportDropped(int[] seed, List<List<TestValue>> candidates) {
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

  /**
   * Whether a kept case satisfies the conditions. Incomplete cases are checked when they are
   * completed.
   */
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
        conditions.pre().stream().filter(c -> !constraints.holds(c, variables)).findFirst();
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
   * The values of a kept case. Values that the model no longer generates are treated as invalid.
   */
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
