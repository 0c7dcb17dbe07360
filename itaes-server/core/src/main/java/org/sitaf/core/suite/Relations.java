package org.sitaf.core.suite;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.model.TestModel;

/** The compiled relations of a model between two runs of a case. */
public final class Relations {
  /** No relations. */
  public static final Relations NONE = new Relations(List.of());

  /** The outputs of the first run, with the inputs of the case. */
  public static final String BEFORE = "before";

  /** The outputs of the second run, with changed inputs. */
  public static final String AFTER = "after";

  /** The return value in {@link #BEFORE} and {@link #AFTER}. */
  public static final String VALUE = "value";

  private final List<Compiled> relations;

  /**
   * A compiled relation.
   *
   * @param changes by the position of the input in the model
   */
  record Compiled(String name, Map<Integer, Expression> changes, Expression holds) {
    Compiled {
      Objects.requireNonNull(name);
      changes = Map.copyOf(changes);
      Objects.requireNonNull(holds);
    }
  }

  Relations(List<Compiled> relations) {
    this.relations = List.copyOf(relations);
  }

  /**
   * Compiles the relations of a model.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if an expression is invalid
   */
  public static Relations of(TestModel model) {
    if (model.relations().isEmpty()) {
      return NONE;
    }
    Diagnostics diagnostics = new Diagnostics();
    Conditions conditions = Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();
    return conditions.relations();
  }

  /** Whether there are none. */
  public boolean isEmpty() {
    return relations.isEmpty();
  }

  /** The names of the relations, in the order of the model. */
  public List<String> names() {
    return relations.stream().map(Compiled::name).toList();
  }

  List<Compiled> all() {
    return relations;
  }

  /**
   * Whether a relation holds.
   *
   * @param index position in {@link #names()}
   * @param variables the inputs of the first run, {@link #BEFORE} and {@link #AFTER}
   * @throws EvaluationException if the condition cannot be evaluated
   */
  public boolean holds(int index, Map<String, Object> variables) throws EvaluationException {
    return relations.get(index).holds().isTrue(variables);
  }

  /** What the condition of a relation compares; empty if it compares nothing. */
  public String explain(int index, Map<String, Object> variables) {
    return relations.get(index).holds().explain(variables);
  }

  /** The text of the condition of a relation. */
  public String condition(int index) {
    return relations.get(index).holds().text();
  }
}
