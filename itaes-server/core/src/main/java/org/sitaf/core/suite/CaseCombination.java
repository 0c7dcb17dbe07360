package org.sitaf.core.suite;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.CoveringArray;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TestDataCombinator;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
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
  private final RelatedInputs related;
  private final KeptRows kept;
  private final ImpossibleCombinations impossible;
  private final ConditionConstraints constraints;
  private final PartProblems problems;

  /** The number of tuples of all parts that are combined so far. */
  private long required;

  private Generation.@Nullable Tuples tuples;

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
    this.related = new RelatedInputs(model, data);
    this.constraints = new ConditionConstraints(model, conditions.pre(), related);
    this.kept =
        new KeptRows(model, data, keptCases, conditions.pre(), constraints, related, diagnostics);
    this.problems = new PartProblems(model, strength, constraints, related, kept);
  }

  /** The rows of all cases. Two rows never have the same values. */
  List<List<TestValue>> rows(InvalidValues invalidValues) {
    related.report(data, diagnostics);
    List<CasePart> parts = invalidValues == InvalidValues.ISOLATE ? isolated() : mixed();
    diagnostics.throwIfErrors();
    int most = options.maxCases() == null ? model.maxCases() : options.maxCases();
    if (most == TestModel.UNBOUNDED) {
      checkSize(parts);
      return complete(parts);
    }
    CaseLimit limit = new CaseLimit(model, most, problems, kept, options.seed(), progress);
    Optional<List<List<TestValue>>> fitting =
        conditions.pre().isEmpty() && leastCases(parts).compareTo(BigInteger.valueOf(most)) > 0
            ? Optional.empty()
            : completeUpTo(most, parts);
    if (fitting.isPresent()) {
      tuples = new Generation.Tuples(required, required);
      return fitting.get();
    }
    List<List<TestValue>> rows = limit.rows(parts, diagnostics);
    tuples = limit.tuples();
    return rows;
  }

  /** The covered tuples; null if the number of cases is not bounded. */
  Generation.@Nullable Tuples tuples() {
    return tuples;
  }

  private Optional<List<List<TestValue>>> completeUpTo(int most, List<CasePart> parts) {
    try {
      List<List<TestValue>> rows = complete(parts);
      return rows.size() <= most ? Optional.of(rows) : Optional.empty();
    } catch (TooManyCombinationsException e) {
      return Optional.empty();
    }
  }

  private List<List<TestValue>> complete(List<CasePart> parts) {
    DistinctRows rows = new DistinctRows();
    rows.addAll(kept.rows());
    for (CasePart part : parts) {
      if (!part.single() || !rows.contains(part.held(), part.heldValue().value())) {
        rows.addAll(combine(part));
      }
      if (rows.size() > MAX_CASES) {
        throw tooMany("more than " + MAX_CASES);
      }
    }
    impossible.report(diagnostics);
    return rows.all();
  }

  /** Combines valid and invalid values alike. */
  private List<CasePart> mixed() {
    List<List<TestValue>> combined =
        data.stream().map(d -> combined(d.values().stream()).toList()).toList();
    List<CasePart> parts = new ArrayList<>();
    parts.add(new CasePart(combined, -1, false, null));
    held(combined, TestValue::each).forEach(h -> parts.add(h.part(combined, true, null)));
    return parts;
  }

  /**
   * Combines all t-tuples of valid values in valid cases, and each invalid value with all
   * (t-1)-tuples of valid values of the other parameters. One error can then not mask another.
   */
  private List<CasePart> isolated() {
    List<List<TestValue>> valid =
        data.stream()
            .map(d -> combined(d.values().stream().filter(TestValue::valid)).toList())
            .toList();
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
    List<CasePart> parts = new ArrayList<>();
    parts.add(new CasePart(valid, -1, false, true));
    held(valid, v -> v.each() && v.valid()).forEach(h -> parts.add(h.part(valid, true, true)));
    held(valid, v -> !v.valid()).forEach(h -> parts.add(h.part(valid, h.value().each(), false)));
    return parts;
  }

  /**
   * The values that are combined. If all are special values with a case each, the other parameters
   * are combined with the one next to zero.
   */
  private static Stream<TestValue> combined(Stream<TestValue> values) {
    List<TestValue> all = values.toList();
    return all.stream().allMatch(TestValue::each)
        ? all.stream()
            .min(Comparator.comparingDouble(v -> Math.abs(Double.parseDouble(v.value().literal()))))
            .stream()
        : all.stream().filter(v -> !v.each());
  }

  /** A value to which a parameter is fixed. */
  private record Held(int parameter, TestValue value) {
    CasePart part(List<List<TestValue>> others, boolean single, @Nullable Boolean valid) {
      List<List<TestValue>> candidates = new ArrayList<>(others);
      candidates.set(parameter, List.of(value));
      return new CasePart(candidates, parameter, single, valid);
    }
  }

  /** The values that are not combined and fulfil a condition. */
  private List<Held> held(List<List<TestValue>> combined, Predicate<TestValue> wanted) {
    List<Held> all = new ArrayList<>();
    for (int p = 0; p < data.size(); p++) {
      for (TestValue value : data.get(p).values()) {
        if (wanted.test(value) && !combined.get(p).contains(value)) {
          all.add(new Held(p, value));
        }
      }
    }
    return all;
  }

  /**
   * Rejects models that need too many cases. Models with pre-conditions may need fewer cases and
   * are not checked here.
   */
  private void checkSize(List<CasePart> parts) {
    if (!conditions.pre().isEmpty()) {
      return;
    }
    BigInteger cases = leastCases(parts);
    if (cases.compareTo(BigInteger.valueOf(MAX_CASES)) > 0) {
      throw tooMany(String.format(Locale.ROOT, "at least %,d", cases));
    }
  }

  private BigInteger leastCases(List<CasePart> parts) {
    return parts.stream()
        .map(part -> part.valid() == null ? BigInteger.ONE : atLeast(part))
        .reduce(BigInteger.ZERO, BigInteger::add);
  }

  /** The product of the largest numbers of values, without those of the fixed parameter. */
  private BigInteger atLeast(CasePart part) {
    if (part.single()) {
      return BigInteger.ONE;
    }
    return IntStream.range(0, part.candidates().size())
        .filter(p -> p != part.held())
        .map(p -> -part.candidates().get(p).size())
        .sorted()
        .limit(Math.max(0, part.held() < 0 ? strength.t() : strength.t() - 1))
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

  /** Generates the rows of one part. */
  private List<List<TestValue>> combine(CasePart part) {
    CombinationProblem problem = problems.problem(part);
    CoveringArray array =
        new TestDataCombinator().combine(problem, options.effort(), options.seed(), progress);
    impossible.add(array.tuples(), part.candidates(), part.held());
    required += array.size() == 0 ? 0 : PartProblems.required(part, array.tuples().covered());
    if (part.held() >= 0 && array.size() == 0) {
      impossible.addValue(part.held(), part.candidates());
    }
    List<int[]> seeds = problem.seeds();
    for (int rejected : array.rejectedSeeds()) {
      kept.reportDropped(seeds.get(rejected), part.candidates());
    }
    List<List<TestValue>> rows = new ArrayList<>();
    for (int[] row : array.rows()) {
      rows.add(problems.row(row, part));
    }
    return rows;
  }
}
