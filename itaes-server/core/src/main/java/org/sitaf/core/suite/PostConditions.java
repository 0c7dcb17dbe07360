package org.sitaf.core.suite;

import java.util.List;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.model.TestModel;

/** What a model wants of every case after the call. */
public final class PostConditions {
  private PostConditions() {}

  /**
   * The post-conditions of a model, compiled.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException when one is not usable
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
