package org.sitaf.core.expression;

import dev.cel.common.CelAbstractSyntaxTree;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelRuntime;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** A compiled CEL expression; immutable. */
public final class Expression {
  private final String text;
  private final CelRuntime.Program program;
  private final Set<String> names;

  Expression(String text, CelAbstractSyntaxTree ast, CelRuntime.Program program) {
    this.text = text;
    this.program = program;
    Set<String> found = new TreeSet<>();
    ast.getReferenceMap()
        .forEach(
            (id, reference) -> {
              if (reference.overloadIds().isEmpty() && reference.value().isEmpty()) {
                found.add(reference.name());
              }
            });
    this.names = Set.copyOf(found);
  }

  /** The expression as it was written. */
  public String text() {
    return text;
  }

  /** Whether the expression asks for a variable. */
  public boolean mentions(String variable) {
    return names.contains(variable);
  }

  /**
   * Evaluates to a boolean.
   *
   * @throws EvaluationException when it cannot be evaluated, or to something else
   */
  public boolean isTrue(Map<String, Object> variables) throws EvaluationException {
    if (evaluate(variables) instanceof Boolean truth) {
      return truth;
    }
    throw new EvaluationException("'" + text + "' is neither true nor false");
  }

  /**
   * Evaluates to a value: Long, Double, Boolean, String, List or Map.
   *
   * @throws EvaluationException when it cannot be evaluated, such as a division by zero
   */
  public Object evaluate(Map<String, Object> variables) throws EvaluationException {
    try {
      return program.eval(variables);
    } catch (CelEvaluationException e) {
      String message = String.valueOf(e.getMessage());
      throw new EvaluationException(message.replaceFirst("^evaluation error[^:]*: ", ""));
    }
  }
}
