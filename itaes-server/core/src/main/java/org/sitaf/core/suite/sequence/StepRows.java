package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.MixedStrength;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * The rows of values of one call, or those before the first step.
 *
 * @param valid rows of the t-way suite, each to be used
 * @param invalid rows with an invalid value, each to be used once
 * @param choices valid rows with every combination of the values that decide about the state
 *     afterwards
 */
record StepRows(List<StepRow> valid, List<StepRow> invalid, List<StepRow> choices) {
  StepRows {
    valid = List.copyOf(valid);
    invalid = List.copyOf(invalid);
    choices = List.copyOf(choices);
  }

  /** The rows of an event. */
  static final StepRows NONE =
      new StepRows(List.of(StepRow.NONE), List.of(), List.of(StepRow.NONE));

  /**
   * Generates the rows of a call.
   *
   * @param deciding inputs that decide about the state afterwards
   */
  static StepRows of(
      TestModel model, Set<String> deciding, GenerationOptions options, Diagnostics diagnostics) {
    if (model.inputs().isEmpty()) {
      return NONE;
    }
    TestModel inputs = model.withoutOutputs();
    var generated = TestCaseGenerator.generate(inputs, options, Progress.NONE);
    diagnostics.addAll(generated.notes());
    List<StepRow> rows = rows(inputs, generated.suite().cases(), options.seed());
    List<StepRow> valid = rows.stream().filter(StepRow::isValid).toList();
    List<StepRow> invalid = rows.stream().filter(r -> !r.isValid()).toList();
    Set<StepRow> choices = new LinkedHashSet<>();
    if (!deciding.isEmpty()) {
      TestModel all =
          inputs.withMixedStrengths(
              deciding.size() < 2
                  ? List.of()
                  : List.of(new MixedStrength(Strength.parse("all"), List.copyOf(deciding))));
      GenerationOptions single =
          new GenerationOptions(
              new Strength(1), options.invalidValues(), options.seed(), options.effort());
      choices.addAll(
          rows(
                  inputs,
                  TestCaseGenerator.generate(all, single, Progress.NONE).suite().cases(),
                  options.seed())
              .stream()
              .filter(StepRow::isValid)
              .toList());
    }
    choices.addAll(valid);
    return new StepRows(valid, invalid, deciding.isEmpty() ? valid : List.copyOf(choices));
  }

  private static List<StepRow> rows(TestModel model, List<TestCase> cases, long seed) {
    InputValidity validity = new InputValidity(model, seed);
    List<StepRow> rows = new ArrayList<>();
    for (TestCase testCase : cases) {
      rows.add(StepRow.of(model, testCase.values(), testCase.valid(), validity));
    }
    return rows;
  }
}
