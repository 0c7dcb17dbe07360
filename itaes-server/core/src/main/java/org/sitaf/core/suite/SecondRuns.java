package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestValue;

/** Changes the inputs of valid cases for the second runs of relations. */
public final class SecondRuns {
  private static final int MAX_SHOWN = 200;

  private final TestModel model;
  private final @Nullable WorldDescription world;
  private final GivenCases cases;

  private SecondRuns(TestModel model, @Nullable WorldDescription world) {
    this.model = model;
    this.world = world;
    this.cases = new GivenCases(model);
  }

  /**
   * The second runs of all relations of a model, in its order.
   *
   * @param suite of the model, or a part of it
   * @param world limits the parameters of the world; null if there is none
   * @throws org.sitaf.core.diagnostic.InvalidInputException if a condition is invalid
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static List<SecondRun> of(
      TestModel model, TestSuite suite, @Nullable WorldDescription world) {
    Relations relations = Relations.of(model);
    if (relations.isEmpty()) {
      return List.of();
    }
    SecondRuns runs = new SecondRuns(model, world);
    return relations.all().stream().map(relation -> runs.of(relation, suite)).toList();
  }

  private SecondRun of(Relations.Compiled relation, TestSuite suite) {
    List<TestCase> changed = new ArrayList<>();
    Map<Integer, SecondRun.Reason> left = new HashMap<>();
    SecondRun.Reason costly = null;
    for (TestCase testCase : suite.cases()) {
      Interruption.check();
      if (!testCase.valid()) {
        continue;
      }
      if (costly != null) {
        // The other cases would most likely exceed the limit, too.
        left.put(testCase.no(), costly);
        continue;
      }
      try {
        List<Value> values = values(relation, testCase);
        Optional<TestCase> second = cases.of(testCase.no(), values);
        second.ifPresent(changed::add);
        if (second.isEmpty()) {
          left.put(
              testCase.no(),
              new SecondRun.Reason(false, "the changed inputs violate a pre-condition"));
        }
      } catch (EvaluationException e) {
        SecondRun.Reason failed =
            new SecondRun.Reason(true, "a change cannot be evaluated: " + e.getMessage());
        left.put(testCase.no(), failed);
        costly = e.tooCostly() ? failed : null;
      } catch (IllegalArgumentException e) {
        left.put(testCase.no(), new SecondRun.Reason(false, String.valueOf(e.getMessage())));
      }
    }
    return new SecondRun(relation.name(), suite.withCases(changed), left);
  }

  /**
   * The values of the second run.
   *
   * @throws EvaluationException if a change cannot be evaluated
   * @throws IllegalArgumentException if a changed value does not fit
   */
  private List<Value> values(Relations.Compiled relation, TestCase testCase)
      throws EvaluationException {
    List<TestValue> row = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      row.add(new TestValue(value(model.inputs().get(i), testCase.values().get(i)), true));
    }
    Variables variables = CaseVariables.of(model, row);
    List<Value> values = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      Value value = row.get(i).value();
      Expression change = relation.changes().get(i);
      values.add(
          change == null
              ? value
              : changed(model.inputs().get(i), value.literal(), change, variables));
    }
    return values;
  }

  private static Value value(InputElement input, String literal) {
    return input.kind() == InputKind.TDTS
        ? Value.parseAnswer(literal, input.type())
        : Value.parse(literal, input.type());
  }

  private Value changed(InputElement input, String literal, Expression change, Variables variables)
      throws EvaluationException {
    if (input.kind() == InputKind.TDTS && Value.isErrorOrDelay(literal)) {
      throw new IllegalArgumentException(
          "the answer " + input.name() + " is " + shown(literal) + " instead of a value");
    }
    Object result = change.evaluate(variables.map());
    try {
      Value value = fitting(ResultLiteral.of(result, input.type()), input.type());
      requireInRange(input, value);
      return value;
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "the changed value of "
              + input.name()
              + " does not fit "
              + input.realType()
              + ": "
              + e.getMessage(),
          e);
    }
  }

  /**
   * The value of a literal.
   *
   * @throws IllegalArgumentException if the type cannot hold it
   */
  private static Value fitting(String literal, DataType type) {
    if (Value.isOutcome(literal) || Value.isErrorOrDelay(literal)) {
      throw new IllegalArgumentException(shown(literal) + " is not a value");
    }
    if (type instanceof DataType.Enumeration enumeration
        && !enumeration.literals().contains(literal)) {
      throw new IllegalArgumentException(
          shown(literal) + " is not one of " + enumeration.literals());
    }
    Value value = Value.parse(literal, type);
    if (type instanceof DataType.Scalar scalar
        && scalar.type() == ScalarType.FLOAT
        && value instanceof Value.Real real) {
      return new Value.Real((float) real.number());
    }
    Object plain = Variables.plain(literal, type);
    if (type instanceof DataType.FixedArray array
        && plain instanceof List<?> cells
        && cells.size() != array.length()) {
      throw new IllegalArgumentException(cells.size() + " elements instead of " + array.length());
    }
    return value;
  }

  private void requireInRange(InputElement input, Value value) {
    if (input.kind() != InputKind.TDSD || world == null) {
      return;
    }
    double number =
        value instanceof Value.Whole whole
            ? whole.number().doubleValue()
            : value instanceof Value.Real real ? real.number() : Double.NaN;
    FaultName.find(input.name())
        .flatMap(fault -> DeviceFaults.problem(fault, number))
        .ifPresent(
            problem -> {
              throw new IllegalArgumentException(value.literal() + " " + problem);
            });
    WorldParameter parameter = world.parameter(input.name()).orElse(null);
    if (parameter == null) {
      return;
    }
    if (!parameter.contains(number)) {
      throw new IllegalArgumentException(
          value.literal() + " is outside the range " + parameter.range() + " of the world");
    }
  }

  private static String shown(String literal) {
    return literal.length() <= MAX_SHOWN ? literal : literal.substring(0, MAX_SHOWN) + "…";
  }
}
