package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.CaseScope;
import org.sitaf.core.suite.Relations;
import org.sitaf.core.suite.SecondRun;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.verdict.CaseRecord.Outcome;

/** Judges the relations of a model after the first run of each case. */
final class RelationVerdicts {
  private final TestModel model;
  private final Relations relations;
  private final List<Executed> runs;
  private final BiPredicate<TestCase, CaseRecord> expectsException;

  /** The second runs for one relation, by case number. */
  private record Executed(
      Map<Integer, TestCase> cases,
      Map<Integer, CaseRecord> records,
      Map<Integer, SecondRun.Reason> left,
      String reasonOfRest) {
    static Executed of(ExecutedSecondRun executed) {
      Map<Integer, TestCase> cases = new HashMap<>();
      executed.run().suite().cases().forEach(c -> cases.put(c.no(), c));
      Map<Integer, CaseRecord> records = new HashMap<>();
      executed.records().forEach(r -> records.putIfAbsent(r.no(), r));
      return new Executed(cases, records, executed.run().left(), executed.reasonOfRest());
    }
  }

  /**
   * @param runs one for each relation, in the order of the model; empty if none were executed
   * @param expectsException whether an exception is right in a second run
   */
  RelationVerdicts(
      TestModel model,
      List<ExecutedSecondRun> runs,
      BiPredicate<TestCase, CaseRecord> expectsException) {
    this.model = model;
    this.relations = runs.isEmpty() ? Relations.NONE : Relations.of(model);
    this.runs = runs.stream().map(Executed::of).toList();
    this.expectsException = expectsException;
  }

  /**
   * The result of a case with its relations.
   *
   * @param completed whether the first run returned or threw an expected exception
   * @param surroundings gives the values of the inputs for CEL, if they are needed
   */
  CaseResult judge(
      TestCase testCase,
      CaseRecord record,
      CaseResult result,
      boolean completed,
      Supplier<Map<String, Object>> surroundings) {
    if (relations.isEmpty() || !testCase.valid() || record.outcome() == Outcome.NOT_CALLED) {
      return result;
    }
    Map<String, Object> inputs = surroundings.get();
    CaseResult judged = result;
    List<RelationResult> results = new ArrayList<>();
    for (int i = 0; i < relations.names().size(); i++) {
      RelationResult relation = judge(i, testCase, record, completed, inputs);
      results.add(relation);
      String reason = "relation '" + relation.name() + "' " + relation.message();
      if (relation.outcome() == RelationResult.Outcome.FAIL) {
        judged = judged.withVerdict(judged.verdict().worse(Verdict.FAIL), reason);
      } else if (relation.outcome() == RelationResult.Outcome.ERROR && completed) {
        judged = judged.withVerdict(Verdict.ERROR, reason);
      }
    }
    return judged.withRelations(results);
  }

  private RelationResult judge(
      int index,
      TestCase testCase,
      CaseRecord before,
      boolean completed,
      Map<String, Object> inputs) {
    String name = relations.names().get(index);
    Executed run = runs.get(index);
    SecondRun.Reason reason = run.left().get(testCase.no());
    if (reason != null) {
      return reason.failed()
          ? without(name, RelationResult.Outcome.ERROR, "cannot be checked: " + reason.message())
          : without(name, RelationResult.Outcome.SKIPPED, reason.message());
    }
    TestCase second = run.cases().get(testCase.no());
    CaseRecord after = run.records().get(testCase.no());
    if (second == null || after == null || after.outcome() == Outcome.NOT_CALLED) {
      String why =
          after != null && !after.message().isEmpty() ? after.message() : run.reasonOfRest();
      return without(
          name,
          RelationResult.Outcome.ERROR,
          "cannot be checked: the second run was not executed" + (why.isEmpty() ? "" : ": " + why));
    }
    if (!completed) {
      return executed(
          name,
          RelationResult.Outcome.ERROR,
          second,
          after,
          "cannot be checked: the first run failed");
    }
    boolean unexpected = after.outcome() == Outcome.THREW && !expectsException.test(second, after);
    if (unexpected || after.outcome() == Outcome.ERROR) {
      return executed(
          name,
          RelationResult.Outcome.ERROR,
          second,
          after,
          "cannot be checked: the second run failed: "
              + after.message()
              + " (first run: "
              + shown(testCase)
              + "; second run: "
              + shown(second)
              + ")");
    }
    return compared(index, testCase, before, second, after, inputs);
  }

  private RelationResult compared(
      int index,
      TestCase testCase,
      CaseRecord before,
      TestCase second,
      CaseRecord after,
      Map<String, Object> inputs) {
    String name = relations.names().get(index);
    Map<String, Object> variables = new HashMap<>(inputs);
    String runs =
        "first run: "
            + shown(testCase)
            + " gave "
            + outputs(before)
            + "; second run: "
            + shown(second)
            + " gave "
            + outputs(after);
    try {
      variables.put(Relations.BEFORE, map(before));
      variables.put(Relations.AFTER, map(after));
      if (relations.holds(index, variables)) {
        return executed(name, RelationResult.Outcome.PASS, second, after, "");
      }
      String compared = relations.explain(index, variables);
      return executed(
          name,
          RelationResult.Outcome.FAIL,
          second,
          after,
          "is broken: " + (compared.isEmpty() ? "" : compared + "; ") + runs);
    } catch (EvaluationException | IllegalArgumentException e) {
      return executed(
          name,
          RelationResult.Outcome.ERROR,
          second,
          after,
          "cannot be checked: "
              + relations.condition(index)
              + ": "
              + e.getMessage()
              + " ("
              + runs
              + ")");
    }
  }

  private static RelationResult without(
      String name, RelationResult.Outcome outcome, String message) {
    return new RelationResult(name, outcome, List.of(), List.of(), message);
  }

  private static RelationResult executed(
      String name,
      RelationResult.Outcome outcome,
      TestCase second,
      CaseRecord record,
      String message) {
    return new RelationResult(name, outcome, second.values(), actual(record), message);
  }

  private static List<NamedValue> actual(CaseRecord record) {
    return record.outcome() == Outcome.THREW
        ? List.of(new NamedValue("", Value.ERROR_PREFIX + record.thrown()))
        : record.outputs();
  }

  /** The outputs of a run by name, and its error. */
  private Map<String, Object> map(CaseRecord record) {
    Variables variables = new Variables();
    for (NamedValue actual : record.actual()) {
      Optional<OutputElement> output =
          model.outputs().stream().filter(o -> o.name().equals(actual.output())).findFirst();
      if (output.isPresent() && !output.get().type().isVoid()) {
        variables.put(CaseScope.inRun(output.get().name()), actual.literal(), output.get().type());
      } else if (output.isEmpty()
          && (actual.output().isEmpty() || actual.output().equals(OutputElement.RETURN_NAME))) {
        // The return value is recorded even if the model does not declare it.
        variables.put(
            Relations.VALUE, (Object) Variables.plain(actual.literal(), new DataType.Unknown("")));
      }
    }
    variables.put(Variables.ERROR, (Object) record.thrown());
    return variables.map();
  }

  private String shown(TestCase testCase) {
    return IntStream.range(0, testCase.values().size())
        .mapToObj(
            i -> model.inputs().get(i).name() + "=" + Literals.shortened(testCase.values().get(i)))
        .collect(Collectors.joining(", "));
  }

  private static String outputs(CaseRecord record) {
    List<NamedValue> actual = actual(record);
    return actual.isEmpty()
        ? "nothing"
        : actual.stream()
            .map(
                v ->
                    (v.output().isEmpty() ? "" : v.output() + "=")
                        + Literals.shortened(v.literal()))
            .collect(Collectors.joining(", "));
  }
}
