package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestValue;

/** Converts the pre-conditions of a model to constraints over candidate values. */
final class ConditionConstraints {
  private final TestModel model;
  private final List<Expression> conditions;
  private final Map<Constraint, Expression> conditionOf = new IdentityHashMap<>();

  private final RelatedInputs related;

  ConditionConstraints(TestModel model, List<Expression> conditions, RelatedInputs related) {
    this.model = model;
    this.conditions = conditions;
    this.related = related;
  }

  /**
   * The constraints of all conditions.
   *
   * @param valid whether all cases are valid or invalid; null if they differ
   */
  List<Constraint> constraints(List<List<TestValue>> candidates, @Nullable Boolean valid) {
    conditionOf.clear();
    return conditions.stream().flatMap(c -> constraints(c, candidates, valid)).toList();
  }

  /** The source text of the condition of a constraint. */
  String text(Constraint constraint) {
    Expression condition = conditionOf.get(constraint);
    return condition == null ? "a condition" : condition.text();
  }

  /**
   * Converts a condition. With few combinations of values, it becomes one constraint. With many,
   * such as {@code a == 1 && b == 2} over large parameters, it is split into its operands, which
   * have fewer parameters each. The whole condition is then only needed if an operand cannot be
   * evaluated for some values.
   */
  private Stream<Constraint> constraints(
      Expression condition, List<List<TestValue>> candidates, @Nullable Boolean valid) {
    Constraint whole = constraint(condition, candidates, valid);
    List<Expression> parts =
        hasTable(whole, candidates) ? List.of(condition) : condition.conjuncts();
    if (parts.size() == 1) {
      return Stream.of(whole);
    }
    List<Constraint> constraints = new ArrayList<>();
    boolean complete = true;
    for (Expression part : parts) {
      Constraint constraint = constraint(part, candidates, valid);
      if (hasTable(constraint, candidates)) {
        boolean[] undecided = new boolean[1];
        constraints.add(constraint(part, candidates, valid, undecided));
        complete &= isDecided(constraints.get(constraints.size() - 1), candidates, undecided);
      } else {
        complete = false;
      }
    }
    return complete ? constraints.stream() : Stream.concat(constraints.stream(), Stream.of(whole));
  }

  /** Whether an operand can be evaluated for all values of its parameters. */
  private static boolean isDecided(
      Constraint part, List<List<TestValue>> candidates, boolean[] undecided) {
    int[] parameters = part.parameters();
    int[] tuple = new int[parameters.length];
    for (int i = 0; i >= 0; ) {
      var unused = part.allowed().test(tuple);
      if (undecided[0]) {
        return false;
      }
      for (i = tuple.length - 1; i >= 0; i--) {
        if (++tuple[i] < candidates.get(parameters[i]).size()) {
          break;
        }
        tuple[i] = 0;
      }
    }
    return true;
  }

  private static boolean hasTable(Constraint constraint, List<List<TestValue>> candidates) {
    double combinations = 1;
    for (int p : constraint.parameters()) {
      combinations *= candidates.get(p).size();
    }
    return combinations <= Constraint.MAX_TABLE;
  }

  private Constraint constraint(
      Expression condition, List<List<TestValue>> candidates, @Nullable Boolean valid) {
    return constraint(condition, candidates, valid, null);
  }

  /**
   * Converts a condition to a constraint over the parameters that it uses.
   *
   * @param undecided set to true if the condition cannot be evaluated for some values, which are
   *     then allowed; null if this is an error
   */
  private Constraint constraint(
      Expression condition,
      List<List<TestValue>> candidates,
      @Nullable Boolean valid,
      boolean @Nullable [] undecided) {
    boolean dependsOnAll = valid == null && condition.mentions(Variables.VALID);
    int[] parameters =
        related.withFollowed(
            IntStream.range(0, candidates.size())
                .filter(p -> dependsOnAll || mentions(condition, model.inputs().get(p).name()))
                .toArray());
    Constraint constraint =
        new Constraint(
            parameters,
            tuple -> {
              Variables variables = new Variables();
              boolean allValid = true;
              Value[] inputs = new Value[parameters.length];
              for (int i = 0; i < parameters.length; i++) {
                TestValue value = candidates.get(parameters[i]).get(tuple[i]);
                InputElement input = model.inputs().get(parameters[i]);
                Optional<Value> resolved =
                    related.resolve(parameters[i], RelatedInputs.at(parameters, tuple, candidates));
                if (resolved.isEmpty()) {
                  // Another constraint excludes this row.
                  return true;
                }
                inputs[i] = resolved.get();
                variables.putValidity(input.name(), value.valid());
                allValid &= value.valid();
              }
              variables.put(Variables.VALID, valid == null ? allValid : valid);
              for (int i = 0; i < parameters.length; i++) {
                InputElement input = model.inputs().get(parameters[i]);
                variables.put(input.name(), inputs[i], input.type());
              }
              return undecided == null
                  ? holds(condition, variables)
                  : mayHold(condition, variables, undecided);
            });
    conditionOf.put(constraint, condition);
    return constraint;
  }

  private boolean mayHold(Expression condition, Variables variables, boolean[] undecided) {
    try {
      return condition.isTrue(variables.map());
    } catch (EvaluationException e) {
      if (e.tooCostly()) {
        return holds(condition, variables);
      }
      undecided[0] = true;
      return true;
    }
  }

  /** Evaluates a condition. A failed evaluation is an error in the model. */
  boolean holds(Expression condition, Variables variables) {
    try {
      return condition.isTrue(variables.map());
    } catch (EvaluationException e) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(),
                  line(condition),
                  "pre_condition_spec_list",
                  "'"
                      + condition.text()
                      + "' cannot be evaluated for "
                      + variables.map()
                      + ": "
                      + e.getMessage())));
    }
  }

  /** The line of a pre-condition in the model; 0 if unknown. */
  int line(Expression condition) {
    // The text of a long expression is shortened.
    String start = condition.text().replaceFirst("…$", "");
    return model.preConditions().stream()
        .filter(c -> c.expression().startsWith(start))
        .mapToInt(Condition::line)
        .findFirst()
        .orElse(0);
  }

  /** The line of the condition of a constraint in the model; 0 if unknown. */
  int line(Constraint constraint) {
    Expression condition = conditionOf.get(constraint);
    return condition == null ? 0 : line(condition);
  }

  private static boolean mentions(Expression condition, String input) {
    return Variables.roots(List.of(input, Variables.VALID_PREFIX + input)).stream()
        .anyMatch(condition::mentions);
  }
}
