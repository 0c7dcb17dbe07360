package org.sitaf.core.verdict;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.Supplier;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.PostConditions;
import org.sitaf.core.suite.TestCase;

/** Judges one call: its recorded values and its post-conditions. */
final class CallVerdicts {
  /** Evaluations of a post-condition that may exceed their limits before it is given up. */
  private static final int MAX_COSTLY = 3;

  private final TestModel model;
  private final CallRecord calls;
  private final Expectations expectations;
  private final InputValidity validity;
  private final List<Expression> postConditions;

  /** Evaluations of each post-condition that exceeded their limits. */
  private final AtomicIntegerArray costly;

  /**
   * Creates the judge of a call.
   *
   * @param seed seed of the suite
   */
  CallVerdicts(TestModel model, CallRecord calls, long seed) {
    this.model = Objects.requireNonNull(model);
    this.calls = calls;
    this.expectations = new Expectations(model);
    this.validity = new InputValidity(model, seed);
    this.postConditions = PostConditions.of(model);
    this.costly = new AtomicIntegerArray(postConditions.size());
  }

  /**
   * A judged call.
   *
   * @param completed whether it returned, or threw what it may throw
   * @param accepted whether it threw what only post-conditions allow
   * @param inputs of a completed call, for CEL; most models do not need them
   */
  record Judged(
      CaseResult result,
      boolean completed,
      boolean accepted,
      Supplier<Map<String, Object>> inputs) {}

  /**
   * Compares the recorded values with the expected ones, then evaluates the post-conditions.
   *
   * @param surroundings further variables of the post-conditions
   */
  Judged judge(TestCase testCase, CaseRecord record, Map<String, Object> surroundings) {
    CaseResult result = expectations.judge(testCase, record);
    boolean threw = record.outcome() == CaseRecord.Outcome.THREW;
    Optional<CaseResult> accepted =
        threw && result.verdict() == Verdict.ERROR
            ? accepted(testCase, record, result, surroundings)
            : Optional.empty();
    boolean completed =
        record.outcome() == CaseRecord.Outcome.RETURNED
            || threw && (result.verdict() == Verdict.PASS || accepted.isPresent());
    Supplier<Map<String, Object>> inputs =
        () -> completed ? inputs(testCase, record.thrown()).map() : Map.of();
    CaseResult judged = result;
    if (accepted.isPresent()) {
      judged = accepted.get();
    } else if (completed) {
      judged = withPostConditions(testCase, record, result, surroundings);
    }
    return new Judged(judged, completed, accepted.isPresent(), inputs);
  }

  /** Whether a case may throw the recorded exception. */
  boolean expectsException(TestCase testCase, CaseRecord record) {
    CaseResult result = expectations.judge(testCase, record);
    return result.verdict() == Verdict.PASS
        || accepted(testCase, record, result, Map.of()).isPresent();
  }

  /**
   * Where no output has an expected value, post-conditions about {@code error} decide whether an
   * exception is right. If it is not, the case remains an ERROR.
   */
  private Optional<CaseResult> accepted(
      TestCase testCase, CaseRecord record, CaseResult result, Map<String, Object> surroundings) {
    if (!testCase.expected().isEmpty()
        || postConditions.stream().noneMatch(c -> c.mentions(Variables.ERROR))
        || model.inputs().stream().anyMatch(i -> i.name().equals(Variables.ERROR))) {
      return Optional.empty();
    }
    CaseResult passed =
        new CaseResult(
            result.no(),
            Verdict.PASS,
            result.values(),
            List.of(),
            List.of(new NamedValue("", Value.ERROR_PREFIX + record.thrown())),
            result.calls(),
            record.time(),
            "");
    return Optional.of(withPostConditions(testCase, record, passed, surroundings))
        .filter(judged -> judged.verdict() == Verdict.PASS);
  }

  private CaseResult withPostConditions(
      TestCase testCase, CaseRecord record, CaseResult result, Map<String, Object> surroundings) {
    return withPostConditions(result, () -> variables(testCase, record, result, surroundings));
  }

  /**
   * The result with the post-conditions of the model.
   *
   * @param variables throws IllegalArgumentException if a value is not one of its type
   */
  CaseResult withPostConditions(CaseResult result, Supplier<Map<String, Object>> variables) {
    CaseResult judged = result;
    Map<String, Object> values = null;
    for (int i = 0; i < postConditions.size(); i++) {
      Expression condition = postConditions.get(i);
      Condition written = model.postConditions().get(i);
      String label = written.name().isEmpty() ? condition.text() : written.name();
      if (condition.mentions(Variables.CALLS) && result.calls().leftOut() > 0) {
        judged =
            judged.withVerdict(
                Verdict.ERROR,
                "post-condition cannot be evaluated: "
                    + label
                    + ": of "
                    + (result.calls().recorded().size() + result.calls().leftOut())
                    + " calls only the first "
                    + result.calls().recorded().size()
                    + " were recorded");
        continue;
      }
      if (costly.get(i) >= MAX_COSTLY) {
        judged = judged.withVerdict(Verdict.ERROR, givenUp(label, written));
        continue;
      }
      try {
        if (values == null) {
          values = variables.get();
        }
        if (!condition.isTrue(values)) {
          String compared = condition.explain(values);
          judged =
              judged.withVerdict(
                  judged.verdict().worse(Verdict.FAIL),
                  "post-condition violated: "
                      + label
                      + (compared.isEmpty() ? "" : ": " + compared));
        }
      } catch (EvaluationException | IllegalArgumentException e) {
        if (e instanceof EvaluationException evaluation && evaluation.tooCostly()) {
          costly.incrementAndGet(i);
        }
        judged =
            judged.withVerdict(
                Verdict.ERROR,
                "post-condition cannot be evaluated: "
                    + label
                    + ": "
                    + e.getMessage()
                    + location(written));
      }
    }
    return judged;
  }

  private String givenUp(String label, Condition condition) {
    return "post-condition cannot be evaluated: "
        + label
        + ": it exceeded the limits of an evaluation in "
        + MAX_COSTLY
        + " cases and was not evaluated any more; simplify it"
        + location(condition);
  }

  /** File and line of a condition in parentheses; empty if unknown. */
  private String location(Condition condition) {
    int line = condition.line();
    return line == 0 ? "" : " (" + model.source() + ":" + line + ")";
  }

  /** The inputs of a case for CEL. */
  Variables inputs(TestCase testCase, String thrown) {
    Variables variables = new Variables();
    validity.put(variables, testCase);
    variables.put(Variables.ERROR, (Object) thrown);
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.put(input.name(), testCase.values().get(i), input.type());
    }
    return variables;
  }

  /** The calls of required interfaces for CEL. */
  Map<String, Object> calls(StubCalls made) {
    return calls.of(made);
  }

  private Map<String, Object> variables(
      TestCase testCase, CaseRecord record, CaseResult result, Map<String, Object> surroundings) {
    Variables variables = inputs(testCase, record.thrown());
    surroundings.forEach(variables::put);
    for (NamedValue actual : result.actual()) {
      OutputElement output = model.output(actual.output()).orElse(null);
      if (output != null) {
        variables.put("actual_" + output.name(), actual.literal(), output.type());
        if (MemberPath.root(output.name()).equals(OutputElement.RETURN_NAME)) {
          String part = output.name().substring(OutputElement.RETURN_NAME.length());
          variables.put("actual" + part, actual.literal(), output.type());
        }
      } else if (actual.output().isEmpty() || actual.output().equals(OutputElement.RETURN_NAME)) {
        variables.put(
            "actual", (Object) Variables.plain(actual.literal(), new DataType.Unknown("")));
      }
    }
    variables.put(Variables.CALLS, (Object) calls.of(result.calls()));
    if (model.inputs().stream().noneMatch(i -> i.name().equals(Variables.MESSAGES))) {
      variables.put(Variables.MESSAGES, (Object) calls.messages(result.calls()));
    }
    return variables.map();
  }
}
