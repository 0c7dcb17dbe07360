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
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/**
 * Interface Test Case Generator (ITCG): values for each element, combined, with what is expected of
 * them.
 */
public final class TestCaseGenerator {
  /** The most values of one element. */
  private static final int MAX_VALUES = 200_000;

  /** The most characters of all values of a suite. */
  private static final long MAX_CHARACTERS = 200_000_000;

  private TestCaseGenerator() {}

  /**
   * Generates the cases of a model. The same model and options give the same cases.
   *
   * @throws InvalidInputException when a condition is not usable, no case is allowed, or there
   *     would be too many
   */
  public static GeneratedSuite generate(TestModel model, GenerationOptions options) {
    return generate(model, options, Progress.NONE);
  }

  /**
   * Generates the cases of a model, and says how far it is.
   *
   * @throws InvalidInputException when a condition is not usable, no case is allowed, or there
   *     would be too many
   * @throws java.util.concurrent.CancellationException when the thread is interrupted
   */
  public static GeneratedSuite generate(
      TestModel model, GenerationOptions options, Progress progress) {
    Strength strength = options.strength() == null ? model.strength() : options.strength();
    InvalidValues invalidValues =
        options.invalidValues() == null ? model.invalidValues() : options.invalidValues();
    Diagnostics diagnostics = new Diagnostics();
    Conditions conditions = Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();

    KeptCases kept = KeptCases.of(model, options.earlier(), diagnostics);
    List<TestData> data = values(model, options.seed(), diagnostics);
    List<List<TestValue>> rows =
        combine(
            model,
            new CaseCombination(
                model, data, conditions, strength, options, kept, progress, diagnostics),
            invalidValues);
    if (rows.isEmpty()) {
      diagnostics.error(
          model.source(), 0, "pre_condition_spec_list", "the conditions allow no case at all");
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
                GeneratorVersion.current()),
            model.inputs().stream()
                .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
                .toList(),
            cases);
    return new GeneratedSuite(suite, diagnostics.all());
  }

  /**
   * Whether the conditions and expected values of a model are usable; every problem that is found.
   */
  public static List<Diagnostic> verifyConditions(TestModel model) {
    Diagnostics diagnostics = new Diagnostics();
    Conditions.compile(model, diagnostics);
    return diagnostics.all();
  }

  private static List<TestData> values(TestModel model, long seed, Diagnostics diagnostics) {
    List<TestData> all = new ArrayList<>();
    for (InputElement input : model.inputs()) {
      Interruption.check();
      TestData data = TestDataGenerator.generate(input, seed);
      String where = "test_element " + input.name();
      for (String leftOut : data.leftOut()) {
        diagnostics.warning(
            model.source(),
            input.line(),
            where,
            "the value " + leftOut + " is left out: " + input.realType() + " cannot hold it");
      }
      if (data.values().isEmpty()) {
        diagnostics.error(
            model.source(),
            input.line(),
            where,
            "gives no value; the literals of an enumeration come from the interface of an activity, or"
                + " from a user_value_list");
      }
      if (data.values().size() > MAX_VALUES) {
        diagnostics.error(
            model.source(),
            input.line(),
            where,
            String.format(
                Locale.ROOT,
                "gives %,d values; at most %,d can be combined: let it give fewer",
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
      return invalidValues == InvalidValues.ISOLATE ? combination.isolated() : combination.mixed();
    } catch (WideConstraintException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(),
                  0,
                  "pre_condition_spec_list",
                  "'" + combination.text(e.constraint()) + "' " + e.getMessage())));
    } catch (TooManyCombinationsException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(), 0, "order_of_combinations", String.valueOf(e.getMessage()))));
    }
  }

  /** Valid cases first; a kept case keeps its number, and no other case ever gets it. */
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
      List<ExpectedValue> expected = oracle.expect(no, valid, values);
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
                        "the first %,d of %,d cases have %,d characters; at most %,d are allowed:"
                            + " use shorter values, or fewer of them",
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
              // What a person filled in by hand stays where the model itself expects nothing.
              expected.isEmpty() && numbered.isPresent() ? numbered.get().expected() : expected));
    }
    oracle.tell();
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
