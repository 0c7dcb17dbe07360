package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.combine.WideConstraintException;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.sequence.SequenceGenerator;
import org.sitaf.core.suite.sequence.SequenceVerification;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/**
 * Interface Test Case Generator (ITCG): generates values of each element, combines them to test
 * cases, and computes the expected values.
 */
public final class TestCaseGenerator {
  /** Maximum number of values of one element. */
  private static final int MAX_VALUES = 200_000;

  /** Maximum number of characters of all values of a suite. */
  private static final long MAX_CHARACTERS = 200_000_000;

  private TestCaseGenerator() {}

  /**
   * Generates the cases of a model. The same model and options give the same cases.
   *
   * @throws InvalidInputException if a condition is invalid, no case is allowed, or there are too
   *     many cases
   */
  public static GeneratedSuite generate(TestModel model, GenerationOptions options) {
    return generate(model, options, Progress.NONE);
  }

  /**
   * Generates the cases of a model and reports the progress.
   *
   * @throws InvalidInputException if a condition is invalid, no case is allowed, or there are too
   *     many cases
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static GeneratedSuite generate(
      TestModel model, GenerationOptions options, Progress progress) {
    if (model.sequence() != null) {
      return SequenceGenerator.generate(model, options, progress);
    }
    Strength strength = options.strength() == null ? model.strength() : options.strength();
    InvalidValues invalidValues =
        options.invalidValues() == null ? model.invalidValues() : options.invalidValues();
    Diagnostics diagnostics = new Diagnostics();
    Conditions conditions = Conditions.compile(model, diagnostics);
    TrajectoryConditions.check(model, Double.POSITIVE_INFINITY, diagnostics);
    diagnostics.throwIfErrors();

    KeptCases kept = KeptCases.of(model, options.earlier(), diagnostics);
    List<TestData> data = values(model, options.seed(), diagnostics);
    CaseCombination combination =
        new CaseCombination(
            model, data, conditions, strength, options, kept, progress, diagnostics);
    List<List<TestValue>> rows = combine(model, combination, invalidValues);
    if (rows.isEmpty()) {
      diagnostics.error(
          model.source(), 0, "pre_condition_spec_list", "no case satisfies the conditions");
    }
    diagnostics.throwIfErrors();
    Oracle oracle = new Oracle(model, conditions, diagnostics);
    List<TestCase> cases = number(model, rows, kept, oracle);

    TestSuite suite =
        new TestSuite(
            model.name() + "-" + (strength.isAll() ? "all" : strength.t() + "way"),
            model.description(),
            model.name(),
            new Generation(
                strength,
                invalidValues,
                options.seed(),
                options.effort().name().toLowerCase(Locale.ROOT),
                GeneratorVersion.current(),
                combination.tuples() == null
                    ? null
                    : options.maxCases() == null ? model.maxCases() : options.maxCases(),
                combination.tuples()),
            model.inputs().stream()
                .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
                .toList(),
            cases);
    verifyRelations(model, suite, diagnostics);
    return new GeneratedSuite(suite, diagnostics.all());
  }

  /** Reports relations that are never checked. */
  private static void verifyRelations(TestModel model, TestSuite suite, Diagnostics diagnostics) {
    if (model.relations().isEmpty()) {
      return;
    }
    if (suite.validCount() == 0) {
      diagnostics.error(
          model.source(),
          model.relations().get(0).line(),
          "relation_list",
          "has no effect, since the suite has no valid case");
      diagnostics.throwIfErrors();
    }
    List<SecondRun> runs = SecondRuns.of(model, suite, null);
    for (int i = 0; i < runs.size(); i++) {
      Map<Integer, SecondRun.Reason> left = runs.get(i).left();
      if (left.size() == suite.validCount()) {
        SecondRun.Reason first = left.values().iterator().next();
        diagnostics.warning(
            model.source(),
            model.relations().get(i).line(),
            "relation " + runs.get(i).relation(),
            "is checked in none of the valid cases; in one of them: " + first.message());
      }
    }
  }

  /** Compiles the conditions and expected values of a model and returns all problems. */
  public static List<Diagnostic> verifyConditions(TestModel model) {
    Diagnostics diagnostics = new Diagnostics();
    Conditions.compile(model, diagnostics);
    if (model.sequence() != null) {
      SequenceVerification.verify(model, diagnostics);
    }
    return diagnostics.all();
  }

  private static List<TestData> values(TestModel model, long seed, Diagnostics diagnostics) {
    List<TestData> all = new ArrayList<>();
    for (InputElement input : model.inputs()) {
      Interruption.check();
      String where = "test_element " + input.name();
      TestData data;
      try {
        data = TestDataGenerator.generate(input, seed);
      } catch (IllegalArgumentException e) {
        diagnostics.error(
            model.source(), input.line(), where + "/test_spec", String.valueOf(e.getMessage()));
        continue;
      }
      for (String literal : data.unrepresentable()) {
        diagnostics.warning(
            model.source(),
            input.line(),
            where,
            "the value " + literal + " is skipped: " + input.realType() + " cannot represent it");
      }
      if (data.values().isEmpty()) {
        diagnostics.error(
            model.source(),
            input.line(),
            where,
            "has no values; the literals of an enumeration are defined by an interface of the"
                + " activity or by a user_value_list");
      }
      if (data.values().size() > MAX_VALUES) {
        diagnostics.error(
            model.source(),
            input.line(),
            where,
            String.format(
                Locale.ROOT,
                "has %,d values, but at most %,d can be combined; reduce the number of values",
                data.values().size(),
                MAX_VALUES));
      }
      all.add(data);
    }
    diagnostics.throwIfErrors();
    return all;
  }

  private static List<List<TestValue>> combine(
      TestModel model, CaseCombination combination, InvalidValues invalidValues) {
    try {
      return combination.rows(invalidValues);
    } catch (WideConstraintException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(),
                  combination.line(e.constraint()),
                  "pre_condition_spec_list",
                  "'" + combination.text(e.constraint()) + "' " + e.getMessage())));
    } catch (TooManyCombinationsException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(), 0, "order_of_combinations", String.valueOf(e.getMessage()))));
    }
  }

  /** Numbers the cases, valid ones first. Kept cases keep their numbers, which are never reused. */
  private static List<TestCase> number(
      TestModel model, List<List<TestValue>> rows, KeptCases kept, Oracle oracle) {
    List<List<TestValue>> ordered = new ArrayList<>(rows);
    ordered.sort(Comparator.comparing(row -> !isValid(row)));
    int next = kept.highestNumber() + 1;
    List<TestCase> cases = new ArrayList<>();
    Map<Value, String> literals = new HashMap<>();
    long characters = 0;
    for (List<TestValue> row : ordered) {
      Interruption.check();
      List<Value> values = row.stream().map(TestValue::value).toList();
      Optional<KeptCases.Kept> numbered = kept.numbered(values);
      int no = numbered.isPresent() ? numbered.get().no() : next++;
      boolean valid = isValid(row);
      List<ExpectedValue> expected = oracle.expect(no, row);
      characters += characters(values, literals, expected);
      if (characters > MAX_CHARACTERS) {
        throw new InvalidInputException(
            List.of(
                Diagnostic.error(
                    model.source(),
                    0,
                    "input_spec_list",
                    String.format(
                        Locale.ROOT,
                        "the first %,d of %,d cases have %,d characters, but at most %,d are"
                            + " allowed; use shorter or fewer values",
                        cases.size(),
                        rows.size(),
                        characters,
                        MAX_CHARACTERS))));
      }
      cases.add(
          new TestCase(
              no,
              valid,
              values.stream().map(v -> literals.computeIfAbsent(v, Value::literal)).toList(),
              // Expected values that a user entered are kept if the model defines none.
              expected.isEmpty() && numbered.isPresent() ? numbered.get().expected() : expected));
    }
    oracle.report();
    return cases;
  }

  private static long characters(
      List<Value> values, Map<Value, String> literals, List<ExpectedValue> expected) {
    return values.stream()
            .mapToLong(v -> literals.computeIfAbsent(v, Value::literal).length())
            .sum()
        + expected.stream().mapToLong(e -> e.literal().length()).sum();
  }

  private static boolean isValid(List<TestValue> row) {
    return row.stream().allMatch(TestValue::valid);
  }
}
