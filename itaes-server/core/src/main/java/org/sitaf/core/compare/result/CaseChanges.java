package org.sitaf.core.compare.result;

import java.util.List;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseRun;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StepResult;

/**
 * Tells whether a case did something else in two results, by the rules of a comparison of results,
 * but without signals and verdicts.
 */
public final class CaseChanges {
  private final CaseComparison comparison;
  private final RecordsOfResults records;

  /**
   * Creates the rules.
   *
   * @param activity declares the types of outputs that the model does not name
   * @param parameters of the results
   */
  public CaseChanges(Activity activity, TestModel model, List<CaseParameter> parameters) {
    this.comparison = new CaseComparison(activity, model, parameters, ResultComparison.ULP, false);
    this.records = new RecordsOfResults(model);
  }

  /** Whether values, errors or calls differ by more than the last bits. */
  public boolean differ(CaseResult before, CaseResult after) {
    RecordsOfResults.Pair both = records.of(before, after);
    return !comparison
        .compare(
            withSteps(after, true),
            new CaseRun(both.base(), before, null),
            new CaseRun(both.now(), after, null))
        .differences()
        .isEmpty();
  }

  /** The executed case with the steps that its result names. */
  static TestCase withSteps(CaseResult result, boolean valid) {
    return new TestCase(result.no(), valid, result.values(), List.of(), steps(result.steps()));
  }

  private static List<TestStep> steps(List<StepResult> steps) {
    return steps.stream()
        .map(s -> new TestStep(s.name(), s.kind() == StepResult.Kind.VALID, s.values(), List.of()))
        .toList();
  }
}
