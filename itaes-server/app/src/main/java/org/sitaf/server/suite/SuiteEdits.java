package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.ExpectedFormula;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.error.RequestException;

/** Changes of the expected values of a suite. */
final class SuiteEdits {
  private static final String SOURCE = "expected values";
  private static final int MAX_PROBLEMS = 50;

  private SuiteEdits() {}

  @Schema(name = "ExpectedChanges")
  record ExpectedChanges(List<ExpectedChange> changes) {}

  @Schema(name = "ExpectedChange")
  record ExpectedChange(
      @Schema(description = "number of the case") int no,
      @Schema(description = "may be absent if the model has only one output")
          @Nullable String output,
      @Schema(description = "absent to remove the expected value") @Nullable String literal) {}

  @Schema(name = "ExpectedFill")
  record ExpectedFill(
      @Schema(description = "may be absent if the model has only one output")
          @Nullable String output,
      @Schema(description = "CEL expression over the inputs and valid") String expression,
      @Schema(description = "whether existing values are kept; default true")
          @Nullable Boolean onlyEmpty) {}

  /** Sets single expected values. */
  static TestSuite change(TestSuite suite, TestModel model, ExpectedChanges changes) {
    if (changes.changes() == null) {
      throw RequestException.malformed("changes must be given.");
    }
    Map<Integer, TestCase> byNo = new HashMap<>();
    suite.cases().forEach(c -> byNo.put(c.no(), c));
    Diagnostics diagnostics = new Diagnostics();
    for (ExpectedChange change : changes.changes()) {
      TestCase old = byNo.get(change.no());
      if (old == null) {
        diagnostics.error(SOURCE, 0, "case " + change.no(), "is not in the suite");
        continue;
      }
      try {
        OutputElement output = output(model, change.output());
        String literal =
            change.literal() == null || change.literal().isBlank()
                ? null
                : Value.isOutcome(change.literal().strip())
                    ? change.literal().strip()
                    : Value.parse(change.literal(), output.type()).literal();
        byNo.put(change.no(), withExpected(old, name(model, output), literal));
      } catch (IllegalArgumentException e) {
        diagnostics.error(SOURCE, 0, "case " + change.no(), String.valueOf(e.getMessage()));
      }
    }
    diagnostics.throwIfErrors();
    return suite.withCases(suite.cases().stream().map(c -> byNo.getOrDefault(c.no(), c)).toList());
  }

  /** Computes expected values with a formula. */
  static TestSuite fill(TestSuite suite, TestModel model, ExpectedFill fill) {
    if (fill.expression() == null || fill.expression().isBlank()) {
      throw RequestException.malformed("expression must be given.");
    }
    ExpectedFormula formula;
    OutputElement output;
    try {
      output = output(model, fill.output());
      formula =
          ExpectedFormula.compile(
              model, output.name(), fill.expression(), suite.generation().seed());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("expression", String.valueOf(e.getMessage()));
    }
    String name = name(model, output);
    boolean onlyEmpty = fill.onlyEmpty() == null || fill.onlyEmpty();
    Diagnostics diagnostics = new Diagnostics();
    List<TestCase> cases = new ArrayList<>();
    int problems = 0;
    for (TestCase testCase : suite.cases()) {
      boolean filled = testCase.expected().stream().anyMatch(e -> e.output().equals(name));
      if (filled && onlyEmpty) {
        cases.add(testCase);
        continue;
      }
      try {
        cases.add(withExpected(testCase, name, formula.expect(testCase).literal()));
      } catch (EvaluationException | IllegalArgumentException e) {
        if (++problems > MAX_PROBLEMS) {
          break;
        }
        diagnostics.error(
            "expression", 0, "case " + testCase.no(), "has no value: " + e.getMessage());
        if (e instanceof EvaluationException evaluation && evaluation.tooCostly()) {
          // The other cases would exceed the limit, too.
          break;
        }
      }
    }
    diagnostics.throwIfErrors();
    return suite.withCases(cases);
  }

  private static OutputElement output(TestModel model, @Nullable String name) {
    return model
        .output(name == null ? "" : name)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "the model has no output '"
                        + (name == null ? "" : name)
                        + "'; it has "
                        + model.outputs().stream().map(OutputElement::name).toList()));
  }

  /** The output's name in cases: empty if the model has only one output. */
  private static String name(TestModel model, OutputElement output) {
    return model.outputs().size() == 1 ? "" : output.name();
  }

  private static TestCase withExpected(TestCase old, String output, @Nullable String literal) {
    List<ExpectedValue> expected =
        new ArrayList<>(old.expected().stream().filter(e -> !e.output().equals(output)).toList());
    if (literal != null) {
      expected.add(new ExpectedValue(output, literal));
    }
    return new TestCase(old.no(), old.valid(), old.values(), expected, old.steps());
  }
}
