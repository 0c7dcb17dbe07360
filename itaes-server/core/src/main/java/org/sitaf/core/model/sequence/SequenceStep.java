package org.sitaf.core.model.sequence;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.Condition;

/** A kind of step. */
public sealed interface SequenceStep permits SequenceCall, SequenceEvent {
  /** Unique among the steps of a model. */
  String name();

  /** When the step is allowed, over the abstract state; null for always. */
  @Nullable Condition guard();

  /** The state afterwards. Variables without an update keep their values. */
  List<StateUpdate> updates();

  /** Line in the model, from 1; 0 if unknown. */
  int line();
}
