package org.sitaf.core.suite;

import java.util.List;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.model.TestModel;

/** The post-conditions of a model. */
public final class PostConditions {
  private PostConditions() {}

  /**
   * Compiles the post-conditions of a model.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if a condition is invalid
   */
  public static List<Expression> of(TestModel model) {
    if (model.postConditions().isEmpty()) {
      return List.of();
    }
    Diagnostics diagnostics = new Diagnostics();
    Conditions conditions = Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();
    return conditions.post();
  }
}
