package org.sitaf.core.compare;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.compare.OutputComparison.Closeness;
import org.sitaf.core.compare.OutputComparison.Outcome;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;

/** Compares executions of the cases of one model. */
public final class CaseComparison {
  private static final Predicate<String> IS_COMMAND = name -> name.endsWith(".command");

  private final Activity activity;
  private final TestModel model;
  private final List<CaseParameter> parameters;
  private final int ulp;
  private final boolean withVerdicts;

  /**
   * Creates a comparison.
   *
   * @param activity declares the types of outputs that the model does not name
   * @param ulp units in the last place that do not count, at least 0
   * @param withVerdicts whether both versions are judged by the same conditions
   */
  public CaseComparison(
      Activity activity, TestModel model, TestSuite suite, int ulp, boolean withVerdicts) {
    this(activity, model, suite.parameters(), ulp, withVerdicts);
  }

  /** Creates a comparison of cases with these parameters. */
  public CaseComparison(
      Activity activity,
      TestModel model,
      List<CaseParameter> parameters,
      int ulp,
      boolean withVerdicts) {
    if (ulp < 0) {
      throw new IllegalArgumentException("ulp must be at least 0, not " + ulp);
    }
    this.activity = activity;
    this.model = model;
    this.parameters = List.copyOf(parameters);
    this.ulp = ulp;
    this.withVerdicts = withVerdicts;
  }

  /** Compares two executions of a case. */
  public CaseDifferences compare(TestCase testCase, CaseRun base, CaseRun now) {
    return new Pair(testCase, base, now).compare();
  }

  /**
   * How two executions of a case by the same version disagree. One that was not executed disagrees
   * in everything.
   */
  public List<Difference> disagreements(TestCase testCase, CaseRun one, CaseRun other) {
    Pair pair = new Pair(testCase, one, other);
    CaseDifferences found = pair.compare();
    return found.isCompared()
        ? found.differences()
        : List.of(
            pair.difference(
                DifferenceClass.ERROR,
                "",
                one.notCalled(),
                other.notCalled(),
                null,
                "not executed",
                Double.NaN));
  }

  /** The inputs of a case by name. */
  public Map<String, String> inputs(TestCase testCase) {
    Map<String, String> inputs = new LinkedHashMap<>();
    for (int i = 0; i < parameters.size(); i++) {
      inputs.put(parameters.get(i).name(), testCase.values().get(i));
    }
    return inputs;
  }

  private OutputComparison comparison(TestModel of, String output) {
    return new OutputComparison(activity.outputType(of, output), ulp);
  }

  private static DifferenceClass kind(TestModel of, String output) {
    return of.output(output).filter(element -> element.kind() == OutputKind.OBSERVED).isPresent()
        ? DifferenceClass.OBSERVED
        : DifferenceClass.VALUE;
  }

  /** The comparison of one pair of executions. */
  private final class Pair {
    private final TestCase testCase;
    private final CaseRun base;
    private final CaseRun now;
    private final List<Difference> differences = new ArrayList<>();
    private final List<Difference> lastBits = new ArrayList<>();
    private final List<NotComparable> notComparable = new ArrayList<>();

    /** The step that is compared; null for the whole case. */
    private @Nullable TestStep step;

    private int stepNumber;

    Pair(TestCase testCase, CaseRun base, CaseRun now) {
      this.testCase = testCase;
      this.base = base;
      this.now = now;
    }

    CaseDifferences compare() {
      CaseRecord left = base.record();
      CaseRecord right = now.record();
      String reason = reason();
      if (!reason.isEmpty() || left == null || right == null) {
        notComparable.add(new NotComparable(model.name(), testCase.no(), "", reason));
      } else if (!stepDiffers(left, right) && !errorDiffers(left, right)) {
        outputs(left, right);
        calls(left, right);
        Trace leftSignals = base.signals();
        Trace rightSignals = now.signals();
        if (leftSignals != null && rightSignals != null) {
          signals(leftSignals, rightSignals);
        }
        verdict();
      }
      return new CaseDifferences(differences, lastBits, notComparable);
    }

    /** Compares the steps of a sequence up to the first one that differs. */
    private boolean stepDiffers(CaseRecord left, CaseRecord right) {
      int both = Math.min(left.steps().size(), right.steps().size());
      for (int i = 0; i < Math.min(both, testCase.steps().size()); i++) {
        step = testCase.steps().get(i);
        stepNumber = i + 1;
        CaseRecord leftStep = left.steps().get(i).record();
        CaseRecord rightStep = right.steps().get(i).record();
        if (!errorDiffers(leftStep, rightStep)) {
          outputs(leftStep, rightStep);
          calls(leftStep, rightStep);
        }
        if (!differences.isEmpty()) {
          return true;
        }
      }
      step = null;
      return false;
    }

    /** The model of the call that is compared, or of the case. */
    private TestModel compared() {
      SequenceSpec sequence = model.sequence();
      return step == null || sequence == null
          ? model
          : sequence.calls().stream()
              .filter(call -> call.name().equals(Objects.requireNonNull(step).name()))
              .map(SequenceCall::model)
              .findFirst()
              .orElse(model);
    }

    private String reason() {
      String left = base.notCalled();
      String right = now.notCalled();
      if (left.isEmpty() && right.isEmpty()) {
        return "";
      }
      String both = left.equals(right) ? "neither version: " + left : "";
      return !both.isEmpty()
          ? "not executed with " + both
          : left.isEmpty()
              ? "not executed with NEW: " + right
              : "not executed with BASE: " + left + (right.isEmpty() ? "" : "; with NEW: " + right);
    }

    private boolean errorDiffers(CaseRecord left, CaseRecord right) {
      String leftError = ErrorText.of(left);
      String rightError = ErrorText.of(right);
      if (leftError.equals(rightError)) {
        return false;
      }
      String leftType = ErrorText.type(left);
      String rightType = ErrorText.type(right);
      String change =
          leftType.isEmpty()
              ? rightType + " in NEW only"
              : rightType.isEmpty()
                  ? leftType + " in BASE only"
                  : leftType.equals(rightType)
                      ? "other message of " + leftType
                      : rightType + " instead of " + leftType;
      differences.add(
          difference(
              DifferenceClass.ERROR,
              "",
              leftError.isEmpty() ? returned(left) : leftError,
              rightError.isEmpty() ? returned(right) : rightError,
              null,
              change,
              Double.NaN));
      return true;
    }

    private static String returned(CaseRecord record) {
      List<String> values =
          record.actual().stream().map(v -> v.output() + " = " + v.literal()).toList();
      return values.isEmpty() ? "returned" : String.join(", ", values);
    }

    private void outputs(CaseRecord left, CaseRecord right) {
      Map<String, String> leftValues = byName(left.actual());
      Map<String, String> rightValues = byName(right.actual());
      leftValues.forEach(
          (output, literal) -> {
            String other = rightValues.get(output);
            if (other == null) {
              onlyIn("BASE", output);
            } else {
              output(output, literal, other);
            }
          });
      rightValues.keySet().stream()
          .filter(output -> !leftValues.containsKey(output))
          .forEach(output -> onlyIn("NEW", output));
    }

    private void onlyIn(String version, String output) {
      notComparable.add(
          new NotComparable(model.name(), testCase.no(), output, "only " + version + " has it"));
    }

    private void output(String output, String left, String right) {
      Outcome outcome = comparison(compared(), output).compare(left, right);
      add(outcome, kind(compared(), output), output, left, right, null);
    }

    private void calls(CaseRecord left, CaseRecord right) {
      new CallComparison(activity.required(), ulp)
          .compare(left.calls(), right.calls())
          .ifPresent(
              found ->
                  add(
                      found.outcome(),
                      DifferenceClass.CALLS,
                      found.method(),
                      found.base(),
                      found.now(),
                      null));
    }

    private void signals(Trace left, Trace right) {
      if (left.stepNanos() != right.stepNanos()) {
        notComparable.add(
            new NotComparable(
                model.name(),
                testCase.no(),
                SignalDivergence.TIME,
                "the time steps of the worlds differ: %s s and %s s"
                    .formatted(left.stepNanos() / 1e9, right.stepNanos() / 1e9)));
        return;
      }
      divergence(left, right, DifferenceClass.COMMANDS, IS_COMMAND);
      divergence(left, right, DifferenceClass.TRAJECTORY, IS_COMMAND.negate());
    }

    private void divergence(
        Trace left, Trace right, DifferenceClass kind, Predicate<String> selected) {
      SignalDivergence.of(left, right, selected, kind == DifferenceClass.TRAJECTORY, ulp)
          .ifPresent(
              found ->
                  add(
                      new Outcome(
                          found.lastBits() ? Closeness.LAST_BITS : Closeness.DIFFERENT,
                          Math.abs(found.base() - found.now())),
                      kind,
                      found.signal(),
                      Double.toString(found.base()),
                      Double.toString(found.now()),
                      found.seconds()));
    }

    private void verdict() {
      Verdict left = base.result().verdict();
      Verdict right = now.result().verdict();
      if (withVerdicts && differences.isEmpty() && left != right) {
        differences.add(
            difference(
                DifferenceClass.VERDICT,
                "",
                judged(base),
                judged(now),
                null,
                right + " instead of " + left,
                Double.NaN));
      }
    }

    private static String judged(CaseRun run) {
      String message = run.result().message();
      return run.result().verdict() + (message.isEmpty() ? "" : ": " + message);
    }

    private void add(
        Outcome outcome,
        DifferenceClass kind,
        String output,
        String left,
        String right,
        @Nullable Double at) {
      if (outcome.closeness() != Closeness.SAME) {
        (outcome.closeness() == Closeness.LAST_BITS ? lastBits : differences)
            .add(
                difference(
                    kind,
                    output,
                    left,
                    right,
                    at,
                    Double.isNaN(outcome.deviation()) ? "" : "numbers",
                    outcome.deviation()));
      }
    }

    private Difference difference(
        DifferenceClass kind,
        String output,
        String left,
        String right,
        @Nullable Double at,
        String change,
        double deviation) {
      TestStep of = step;
      return new Difference(
          model.name(),
          testCase.no(),
          testCase.valid(),
          kind,
          of == null ? output : output.isEmpty() ? of.name() : of.name() + "." + output,
          inputs(testCase),
          left,
          right,
          at,
          change,
          deviation,
          of == null
              ? null
              : new Difference.Step(
                  stepNumber, of.name() + "(" + String.join(", ", of.values()) + ")"));
    }
  }

  private static Map<String, String> byName(List<NamedValue> values) {
    Map<String, String> byName = new LinkedHashMap<>();
    values.forEach(value -> byName.put(value.output(), value.literal()));
    return byName;
  }
}
