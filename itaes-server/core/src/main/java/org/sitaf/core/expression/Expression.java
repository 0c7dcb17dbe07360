package org.sitaf.core.expression;

import dev.cel.common.ast.CelExpr;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelRuntime;
import dev.cel.runtime.CelVariableResolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.expression.type.TypeCheck;

/**
 * A compiled CEL expression. Immutable. An evaluation is limited in steps and stops when its thread
 * is interrupted.
 */
public final class Expression {
  /** Maximum length of an expression in a message, since each case of a suite may contain one. */
  private static final int MAX_SHOWN = 500;

  private static final Set<String> COMPARISONS =
      Set.of("_<_", "_<=_", "_>_", "_>=_", "_==_", "_!=_");

  private final Source source;
  private final CelExpr parsed;
  private final Type type;
  private final TypeCheck check;
  private final CelRuntime.Program program;
  private final @Nullable DirectProgram direct;
  private final NodeRoles roles;
  private final Set<String> variables;

  /**
   * The document's view of an expression.
   *
   * @param text source text for messages
   */
  record Source(String text, Scope scope, Definitions definitions) {
    /** The definitions that an expression needs, in the order of their evaluation. */
    List<String> needed(CelExpr parsed) {
      Linker linker = new Linker(scope);
      linker.link(parsed);
      return definitions.needed(linker.definitions());
    }

    /** The expression within its definitions. */
    CelExpr withDefinitions(CelExpr parsed) {
      CelExpr whole = parsed;
      for (String name : ExpressionCompiler.reversed(needed(parsed))) {
        whole = Macros.bind(name, definitions.expression(name), whole);
      }
      return whole;
    }
  }

  Expression(Source source, CelExpr parsed, Type type, TypeCheck check)
      throws CelEvaluationException {
    this.source = source;
    this.parsed = parsed;
    this.type = type;
    this.check = check;
    Linker linker = new Linker(source.scope());
    CelExpr linked = linker.link(source.withDefinitions(parsed));
    this.program = Language.program(linked);
    this.direct = DirectProgram.compile(linked).orElse(null);
    this.roles = new NodeRoles(linked);
    this.variables = Set.copyOf(linker.variables());
  }

  /** The source text for messages, truncated if it is long. */
  public String text() {
    return source.text();
  }

  static String shown(String text) {
    return shown(text, MAX_SHOWN);
  }

  static String shown(String text, int length) {
    return text.length() <= length ? text : text.substring(0, length) + "…";
  }

  /** The type of the value, as far as it is known. */
  public Type type() {
    return type;
  }

  /**
   * Warnings about divisions of whole numbers whose result is used as a floating-point number.
   *
   * @param isRealExpected whether the value of the expression is
   */
  public List<String> wholeDivisions(boolean isRealExpected) {
    return check.wholeDivisions(parsed, isRealExpected);
  }

  /** The definitions that the expression uses, directly or by other definitions. */
  public Set<String> definitions() {
    return Set.copyOf(source.needed(parsed));
  }

  /** The variables that the expression uses, directly or by definitions. */
  public Set<String> variables() {
    return variables;
  }

  /** Whether the expression uses a variable. */
  public boolean mentions(String variable) {
    return variables.contains(variable);
  }

  /**
   * The elements of a list that the expression uses, if all their indices are constants.
   *
   * @return empty if the expression uses the list in another way, so that it may need all elements
   */
  public Optional<Set<Long>> indices(String list) {
    return ListUse.indices(new Linker(source.scope()).link(source.withDefinitions(parsed)), list);
  }

  /**
   * A comparison.
   *
   * @param operator one of {@code < <= > >= == !=}
   */
  public record Comparison(Expression left, String operator, Expression right) {}

  /** The two sides, if the expression is a comparison. */
  public Optional<Comparison> comparison() {
    if (!COMPARISONS.contains(function(parsed))) {
      return Optional.empty();
    }
    return Optional.of(
        new Comparison(
            part(parsed.call().args().get(0)),
            parsed.call().function().replace("_", ""),
            part(parsed.call().args().get(1))));
  }

  /**
   * Prepares many evaluations with rows of numbers.
   *
   * @param columns names of the variables in each row
   * @param fixed values of all other variables
   */
  public RowExpression overRows(List<String> columns, Map<String, Object> fixed) {
    return new RowExpression(this, columns, Map.of(), fixed);
  }

  /**
   * Prepares many evaluations with rows of numbers, some of which are elements of lists.
   *
   * @param columns names of the variables in each row
   * @param lists for each variable that is a list the columns of its elements; -1 for an element
   *     that the expression does not use
   * @param fixed values of all other variables
   */
  public RowExpression overRows(
      List<String> columns, Map<String, List<Integer>> lists, Map<String, Object> fixed) {
    return new RowExpression(this, columns, lists, fixed);
  }

  /**
   * The operands of {@code &&} at the top level, each with the text of the whole expression; only
   * this expression if there is no {@code &&}.
   */
  public List<Expression> conjuncts() {
    List<CelExpr> parts = new ArrayList<>();
    operands("_&&_", parsed, parts);
    return parts.size() == 1 ? List.of(this) : parts.stream().map(this::part).toList();
  }

  static void operands(String operator, CelExpr node, List<CelExpr> parts) {
    if (function(node).equals(operator)) {
      node.call().args().forEach(a -> operands(operator, a, parts));
    } else {
      parts.add(node);
    }
  }

  /** The name of the function that a node calls; empty if it calls none. */
  static String function(CelExpr node) {
    return node.getKind() == CelExpr.ExprKind.Kind.CALL ? node.call().function() : "";
  }

  CelExpr parsed() {
    return parsed;
  }

  /** A part of this expression with the text of the whole. */
  Expression part(CelExpr part) {
    try {
      return new Expression(source, part, check.typeOf(part), check);
    } catch (CelEvaluationException e) {
      throw new IllegalStateException(
          "a part of a valid expression does not compile: " + text(), e);
    }
  }

  /**
   * What a false condition compares, such as {@code 1.31 <= 1.2}; empty if it compares nothing.
   *
   * @throws CancellationException if the thread is interrupted
   */
  public String explain(Map<String, Object> values) {
    return shown(new Explanation(this, values).text());
  }

  /**
   * Evaluates to a boolean.
   *
   * @throws EvaluationException if the evaluation fails or the result is not a boolean
   * @throws CancellationException if the thread is interrupted
   */
  public boolean isTrue(Map<String, Object> values) throws EvaluationException {
    if (evaluate(values) instanceof Boolean value) {
      return value;
    }
    throw new EvaluationException("'" + text() + "' is neither true nor false");
  }

  /**
   * Evaluates to a value: Long, Double, Boolean, String, List or Map.
   *
   * @throws EvaluationException if the evaluation fails, such as by a division by zero, or takes
   *     too many steps
   * @throws CancellationException if the thread is interrupted
   */
  public Object evaluate(Map<String, Object> values) throws EvaluationException {
    return evaluate(values::get, meter -> program.trace(values, meter));
  }

  Object evaluate(CelVariableResolver values) throws EvaluationException {
    return evaluate(name -> values.find(name).orElse(null), meter -> program.trace(values, meter));
  }

  /** Evaluates with CEL alone. */
  Object evaluateByCel(Map<String, Object> values) throws EvaluationException {
    return traced(meter -> program.trace(values, meter));
  }

  private interface Evaluation {
    @Nullable Object run(StepMeter meter) throws CelEvaluationException;
  }

  private Object evaluate(DirectProgram.Values values, Evaluation otherwise)
      throws EvaluationException {
    if (direct != null) {
      Optional<Object> value = direct.evaluate(values);
      if (value.isPresent() && !Thread.currentThread().isInterrupted()) {
        return value.get();
      }
    }
    return traced(otherwise);
  }

  private Object traced(Evaluation evaluation) throws EvaluationException {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the evaluation was interrupted");
    }
    try {
      Object value = evaluation.run(new StepMeter(roles));
      if (value == null) {
        throw new EvaluationException("'" + text() + "' has no value");
      }
      return value;
    } catch (StepMeter.Stopped e) {
      if (e.interrupted()) {
        throw new CancellationException(e.getMessage());
      }
      throw new EvaluationException(String.valueOf(e.getMessage()), true);
    } catch (CelEvaluationException e) {
      // Messages can contain long values.
      throw new EvaluationException(shown(Messages.of(e)));
    }
  }
}
