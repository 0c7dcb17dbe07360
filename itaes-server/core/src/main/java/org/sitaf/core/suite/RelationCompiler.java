package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.Relation;
import org.sitaf.core.model.TestModel;

/** Compiles the relations of a model and reports what is wrong with them. */
final class RelationCompiler {
  private final TestModel model;
  private final ExpressionCompiler changes;
  private final ExpressionCompiler conditions;
  private final Diagnostics diagnostics;

  /**
   * @param changes compiles over the inputs
   * @param conditions compiles over {@link CaseScope#betweenRuns}
   */
  RelationCompiler(
      TestModel model,
      ExpressionCompiler changes,
      ExpressionCompiler conditions,
      Diagnostics diagnostics) {
    this.model = model;
    this.changes = changes;
    this.conditions = conditions;
    this.diagnostics = diagnostics;
  }

  /** The valid relations. */
  Relations compile() {
    if (model.relations().isEmpty()) {
      return Relations.NONE;
    }
    checkNames();
    List<Relations.Compiled> compiled = new ArrayList<>();
    for (Relation relation : model.relations()) {
      Map<Integer, Expression> changed = new HashMap<>();
      for (Relation.Change change : relation.changes()) {
        for (int i = 0; i < model.inputs().size(); i++) {
          if (model.inputs().get(i).name().equals(change.input())) {
            int input = i;
            change(relation, change, model.inputs().get(i)).ifPresent(e -> changed.put(input, e));
          }
        }
      }
      holds(relation)
          .ifPresent(e -> compiled.add(new Relations.Compiled(relation.name(), changed, e)));
    }
    return new Relations(compiled);
  }

  /** Names that have two meanings in the condition of a relation. */
  private void checkNames() {
    int line = model.relations().get(0).line();
    for (String root : Variables.roots(model.inputs().stream().map(InputElement::name).toList())) {
      if (root.equals(Relations.BEFORE) || root.equals(Relations.AFTER)) {
        error(
            line,
            "relation_list",
            "an input is named '" + root + "', which names the outputs of a run here; rename it");
      }
    }
    Set<String> outputs = new HashSet<>();
    for (OutputElement output : model.outputs()) {
      String root = MemberPath.root(output.name());
      if (root.equals(Relations.VALUE)
          && model.outputs().stream()
              .anyMatch(o -> MemberPath.root(o.name()).equals(OutputElement.RETURN_NAME))) {
        root = "the return value";
        outputs.add(root);
      }
      if (root.equals(Variables.ERROR) || outputs.contains(root)) {
        error(
            output.line(),
            "test_element " + output.name(),
            "has the name of "
                + (root.equals(Variables.ERROR) ? "the error" : root)
                + " in the before and after of relations; rename it");
      }
    }
  }

  private Optional<Expression> change(
      Relation relation, Relation.Change change, InputElement input) {
    String where = "relation " + relation.name() + "/change " + change.input();
    Optional<Expression> compiled = compile(changes, change.expression(), change.line(), where);
    if (compiled.isEmpty()) {
      return compiled;
    }
    if (!fits(compiled.get().type(), input.type())) {
      error(
          change.line(),
          where,
          "the type of '"
              + compiled.get().text()
              + "' is "
              + compiled.get().type().name()
              + ", but that of the input is "
              + input.type().typeName());
      return Optional.empty();
    }
    boolean isReal = input.type() instanceof DataType.Scalar scalar && scalar.type().isFloating();
    warn(compiled.get(), isReal, change.line(), where);
    return compiled;
  }

  /** Whether an expression of a type can give a value of an input. */
  private static boolean fits(Type given, DataType input) {
    if (given.equals(Type.NULL) || given.equals(Type.OUTCOME)) {
      return false;
    }
    Type wanted = Type.of(input);
    boolean isText =
        input instanceof DataType.Scalar scalar
            && (scalar.type() == ScalarType.STRING || scalar.type() == ScalarType.CHAR);
    return Type.join(wanted, given) != null
        || isText && (given.mayBeNumber() || given.equals(Type.BOOLEAN));
  }

  private Optional<Expression> holds(Relation relation) {
    String where = "relation " + relation.name() + "/holds";
    Optional<Expression> compiled =
        compile(conditions, relation.holds(), relation.holdsLine(), where);
    if (compiled.isEmpty()) {
      return compiled;
    }
    Type type = compiled.get().type();
    if (!type.equals(Type.BOOLEAN) && !type.isOpen()) {
      error(
          relation.holdsLine(),
          where,
          "'" + compiled.get().text() + "' must be true or false, but its type is " + type.name());
      return Optional.empty();
    }
    if (!compiled.get().mentions(Relations.AFTER)) {
      error(
          relation.holdsLine(),
          where,
          "does not use 'after', so the second run has no effect; compare after with before, or"
              + " write a post_condition");
      return Optional.empty();
    }
    warn(compiled.get(), false, relation.holdsLine(), where);
    return compiled;
  }

  private Optional<Expression> compile(
      ExpressionCompiler compiler, String text, int line, String where) {
    try {
      return Optional.of(compiler.compile(text));
    } catch (IllegalArgumentException e) {
      error(line, where, String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  private void warn(Expression expression, boolean isRealExpected, int line, String where) {
    for (String warning : expression.wholeDivisions(isRealExpected)) {
      diagnostics.warning(model.source(), line, where, warning);
    }
  }

  private void error(int line, String where, String message) {
    diagnostics.error(model.source(), line, where, message);
  }
}
