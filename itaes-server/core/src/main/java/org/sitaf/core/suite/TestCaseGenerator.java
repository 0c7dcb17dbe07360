package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.KeptCase;
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
  private TestCaseGenerator() {}

  /**
   * Generates the cases of a model. The same model and options give the same cases.
   *
   * @throws InvalidInputException when a condition is not usable, no case is allowed, or there
   *     would be too many
   */
  public static GeneratedSuite generate(TestModel model, GenerationOptions options) {
    Strength strength = options.strength() == null ? model.strength() : options.strength();
    InvalidValues invalidValues =
        options.invalidValues() == null ? model.invalidValues() : options.invalidValues();
    Diagnostics diagnostics = new Diagnostics();
    Conditions conditions = Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();

    List<TestData> data = values(model, options.seed(), diagnostics);
    List<List<TestValue>> rows =
        combine(
            model,
            new CaseCombination(model, data, conditions, strength, options, diagnostics),
            invalidValues);
    if (rows.isEmpty()) {
      diagnostics.error(
          model.source(), 0, "pre_condition_spec_list", "the conditions allow no case at all");
    }
    diagnostics.throwIfErrors();
    List<TestCase> cases = number(model, rows, new Oracle(model, conditions, diagnostics));

    TestSuite suite =
        new TestSuite(
            model.name() + "-" + (strength.isAll() ? "all" : strength.t() + "way"),
            model.description(),
            model.name(),
            new Generation(
                strength,
                invalidValues,
                options.seed(),
                options.effort().name().toLowerCase(java.util.Locale.ROOT),
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
        diagnostics.error(model.source(), input.line(), where, "gives no value");
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
    } catch (TooManyCombinationsException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(), 0, "order_of_combinations", String.valueOf(e.getMessage()))));
    }
  }

  /** Valid cases first; a kept case keeps its number, and no other case ever gets it. */
  private static List<TestCase> number(TestModel model, List<List<TestValue>> rows, Oracle oracle) {
    List<List<TestValue>> ordered = new ArrayList<>(rows);
    ordered.sort(Comparator.comparing(row -> !isValid(row)));
    Set<Integer> used = new HashSet<>();
    model.keptCases().forEach(k -> used.add(k.no()));
    int next = 1 + used.stream().mapToInt(Integer::intValue).max().orElse(0);
    Set<KeptCase> unnumbered = new HashSet<>(model.keptCases());
    List<TestCase> cases = new ArrayList<>();
    for (List<TestValue> row : ordered) {
      List<Value> values = row.stream().map(TestValue::value).toList();
      KeptCase kept =
          model.keptCases().stream()
              .filter(k -> unnumbered.contains(k) && k.no() > 0 && k.values().equals(values))
              .findFirst()
              .orElse(null);
      if (kept != null) {
        unnumbered.remove(kept);
      }
      int no = kept != null ? kept.no() : next++;
      boolean valid = isValid(row);
      cases.add(
          new TestCase(
              no,
              valid,
              values.stream().map(Value::literal).toList(),
              oracle.expect(no, valid, values)));
    }
    return cases;
  }

  private static boolean isValid(List<TestValue> row) {
    return row.stream().allMatch(TestValue::valid);
  }
}
