package org.sitaf.core.model.sequence;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.Value;

/**
 * A change of the world as a step.
 *
 * @param set a parameter of the world, or a fault of a device
 * @param to its new value
 */
public record SequenceEvent(
    String name,
    String set,
    Value to,
    @Nullable Condition guard,
    List<StateUpdate> updates,
    int line)
    implements SequenceStep {
  public SequenceEvent {
    Objects.requireNonNull(name);
    Objects.requireNonNull(set);
    Objects.requireNonNull(to);
    updates = List.copyOf(updates);
  }

  /** Whether the event sets a fault of a device instead of a parameter of the world. */
  public boolean isFault() {
    return FaultName.isFault(set);
  }
}
