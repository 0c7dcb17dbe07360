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
 * Poses the values of a model as problems for the Test Data Combinator (TDC), and reads its rows
 * back as values.
 */
final class CaseCombination {
  /** The most cases of a suite. */
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
  private final PosedConditions posed;

  /** For each parameter that was held, the kept cases by its value. */
  private final Map<Integer, Map<Value, List<KeptCases.Kept>>> keptByValue = new HashMap<>();

  /** Where each value of some candidates stands; made only for cases to keep. */
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
    this.posed = new PosedConditions(model, conditions.pre());
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
    refuseExplosion(valid);
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
    impossible.tell(diagnostics);
    return List.copyOf(rows);
  }

  /** Refuses what needs too many cases, where no condition lets it need fewer. */
  private void refuseExplosion(List<List<TestValue>> valid) {
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

  /** The product of the largest levels but that of one parameter. */
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
                    "gives %s cases, of which at most %,d can be generated; lower the strength,"
                        + " or give the parameters fewer values",
                    count,
                    MAX_CASES))));
  }

  /** The condition that a constraint comes from, as it was written. */
  String text(Constraint constraint) {
    return posed.text(constraint);
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
    List<int[]> seeds = seeds(candidates, held);
    if ((seeds.isEmpty() && IntStream.of(levels).allMatch(l -> l == 1)) || interactions.isEmpty()) {
      // Nothing varies, or no tuple is asked for: one case, whichever the conditions allow.
      seeds.add(IntStream.of(levels).map(l -> CombinationProblem.FREE).toArray());
    }
    List<Constraint> constraints = posed.constraints(candidates, valid);
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
  private List<int[]> seeds(List<List<TestValue>> candidates, int held) {
    List<int[]> seeds = new ArrayList<>();
    for (KeptCases.Kept keptCase : keptCases(candidates, held)) {
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

  /** Those that can fit: where a parameter is held, those that have its value. */
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
        conditions.pre().stream().filter(c -> !posed.holds(c, variables)).findFirst();
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
