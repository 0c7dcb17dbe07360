package org.sitaf.core.expression;

import dev.cel.common.CelAbstractSyntaxTree;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.navigation.CelNavigableAst;
import dev.cel.common.navigation.CelNavigableExpr;
import dev.cel.runtime.CelEvaluationException;
import dev.cel.runtime.CelRuntime;
import dev.cel.runtime.CelVariableResolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;

/**
 * A compiled CEL expression. Immutable. An evaluation is limited in steps and stops when its thread
 * is interrupted.
 */
public final class Expression {
  /** Maximum length of an expression in a message, since each case of a suite may contain one. */
  private static final int MAX_SHOWN = 500;

  private static final Set<String> COMPARISONS =
      Set.of("_<_", "_<=_", "_>_", "_>=_", "_==_", "_!=_");

  private final String text;
  private final CelAbstractSyntaxTree ast;
  private final CelRuntime runtime;
  private final CelRuntime.Program program;
  private final NodeRoles roles;
  private final Set<String> names;

  Expression(String text, CelAbstractSyntaxTree ast, CelRuntime runtime)
      throws CelEvaluationException {
    this.text = shown(text);
    this.ast = ast;
    this.runtime = runtime;
    this.program = runtime.createProgram(ast);
    this.roles = new NodeRoles(ast.getExpr());
    Set<String> found = new TreeSet<>();
    CelNavigableAst.fromAst(ast)
        .getRoot()
        .allNodes()
        .map(CelNavigableExpr::id)
        .flatMap(id -> ast.getReference(id).stream())
        .filter(r -> r.overloadIds().isEmpty() && r.value().isEmpty())
        .forEach(r -> found.add(r.name()));
    this.names = Set.copyOf(found);
  }

  /** The source text for messages, truncated if it is long. */
  public String text() {
    return text;
  }

  static String shown(String text) {
    return text.length() <= MAX_SHOWN ? text : text.substring(0, MAX_SHOWN) + "…";
  }

  /** The variables that the expression uses. */
  public Set<String> variables() {
    return names;
  }

  /**
   * A comparison.
   *
   * @param operator one of {@code < <= > >= == !=}
   */
  public record Comparison(Expression left, String operator, Expression right) {}

  /** The two sides, if the expression is a comparison. */
  public Optional<Comparison> comparison() {
    CelExpr root = ast.getExpr();
    if (root.getKind() != CelExpr.ExprKind.Kind.CALL
        || !COMPARISONS.contains(root.call().function())) {
      return Optional.empty();
    }
    return Optional.of(
        new Comparison(
            part(root.call().args().get(0)),
            root.call().function().replace("_", ""),
            part(root.call().args().get(1))));
  }

  /**
   * Prepares many evaluations with rows of numbers.
   *
   * @param columns names of the variables in each row
   * @param fixed values of all other variables
   */
  public RowExpression overRows(List<String> columns, Map<String, Object> fixed) {
    return new RowExpression(this, columns, fixed);
  }

  /** Whether the expression uses a variable. */
  public boolean mentions(String variable) {
    return names.contains(variable);
  }

  /**
   * The operands of {@code &&} at the top level, each with the text of the whole expression; only
   * this expression if there is no {@code &&}.
   */
  public List<Expression> conjuncts() {
    List<CelExpr> parts = new ArrayList<>();
    conjuncts(ast.getExpr(), parts);
    if (parts.size() == 1) {
      return List.of(this);
    }
    return parts.stream().map(this::part).toList();
  }

  /** A part of this expression with the text of the whole. */
  private Expression part(CelExpr part) {
    try {
      return new Expression(
          text,
          CelAbstractSyntaxTree.newCheckedAst(
              part, ast.getSource(), ast.getReferenceMap(), ast.getTypeMap()),
          runtime);
    } catch (CelEvaluationException e) {
      throw new IllegalStateException("a part of a valid expression does not compile: " + text, e);
    }
  }

  private static void conjuncts(CelExpr node, List<CelExpr> parts) {
    if (node.getKind() == CelExpr.ExprKind.Kind.CALL && node.call().function().equals("_&&_")) {
      node.call().args().forEach(a -> conjuncts(a, parts));
    } else {
      parts.add(node);
    }
  }

  /**
   * Evaluates to a boolean.
   *
   * @throws EvaluationException if the evaluation fails or the result is not a boolean
   * @throws CancellationException if the thread is interrupted
   */
  public boolean isTrue(Map<String, Object> variables) throws EvaluationException {
    if (evaluate(variables) instanceof Boolean value) {
      return value;
    }
    throw new EvaluationException("'" + text + "' is neither true nor false");
  }

  /**
   * Evaluates to a value: Long, Double, Boolean, String, List or Map.
   *
   * @throws EvaluationException if the evaluation fails, such as by a division by zero, or takes
   *     too many steps
   * @throws CancellationException if the thread is interrupted
   */
  public Object evaluate(Map<String, Object> variables) throws EvaluationException {
    return evaluate((StepMeter meter) -> program.trace(variables, meter));
  }

  Object evaluate(CelVariableResolver variables) throws EvaluationException {
    return evaluate((StepMeter meter) -> program.trace(variables, meter));
  }

  private interface Evaluation {
    Object run(StepMeter meter) throws CelEvaluationException;
  }

  private Object evaluate(Evaluation evaluation) throws EvaluationException {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the evaluation was interrupted");
    }
    try {
      return evaluation.run(new StepMeter(roles));
    } catch (StepMeter.Stopped e) {
      if (e.interrupted()) {
        throw new CancellationException(e.getMessage());
      }
      throw new EvaluationException(String.valueOf(e.getMessage()), true);
    } catch (CelEvaluationException e) {
      String message = String.valueOf(e.getMessage());
      // Messages can contain long values.
      throw new EvaluationException(shown(message.replaceFirst("^evaluation error[^:]*: ", "")));
    }
  }
}
