package org.sitaf.core.model.sequence;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.TestModel;

/**
 * A call as a step.
 *
 * @param forbidden outcome of the call where the guard is false; null if it is not made there
 * @param overlap whether the next step begins while the call runs
 * @param model the call's own test model: target, inputs, outputs and conditions
 */
public record SequenceCall(
    String name,
    @Nullable Condition guard,
    List<StateUpdate> updates,
    @Nullable Condition forbidden,
    boolean overlap,
    TestModel model,
    int line)
    implements SequenceStep {
  public SequenceCall {
    Objects.requireNonNull(name);
    Objects.requireNonNull(model);
    updates = List.copyOf(updates);
  }

  /** A copy with another test model. */
  public SequenceCall withModel(TestModel other) {
    return new SequenceCall(name, guard, updates, forbidden, overlap, other, line);
  }
}
