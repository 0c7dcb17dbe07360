package org.sitaf.core.model.sequence;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.sitaf.core.model.TestModel;

/**
 * Which sequences of calls and events are generated.
 *
 * @param length maximum number of steps of a case
 * @param order the t of the covered t-tuples of steps, at most the length
 * @param repeat whether a step may occur several times in a case
 * @param threads number of threads that call the steps
 * @param line line in the model, from 1; 0 if unknown
 */
public record SequenceSpec(
    int length,
    int order,
    boolean repeat,
    int threads,
    List<StateVariable> states,
    List<SequenceCall> calls,
    List<SequenceEvent> events,
    int line) {
  /** In expressions of a call: the number of its step, from 1. */
  public static final String STEP = "step";

  /** In the model's post-conditions: the list of all steps. */
  public static final String STEPS = "steps";

  public SequenceSpec {
    if (order < 1 || order > length || threads < 1) {
      throw new IllegalArgumentException(
          "order " + order + ", length " + length + ", threads " + threads);
    }
    states = List.copyOf(states);
    calls = List.copyOf(calls);
    events = List.copyOf(events);
  }

  /** The calls, then the events. */
  public List<SequenceStep> steps() {
    List<SequenceStep> steps = new ArrayList<>(calls);
    steps.addAll(events);
    return steps;
  }

  /** Finds a call by name. */
  public Optional<SequenceCall> call(String name) {
    return calls.stream().filter(c -> c.name().equals(name)).findFirst();
  }

  /** A copy with other test models of the calls. */
  public SequenceSpec withModels(UnaryOperator<TestModel> change) {
    return with(states, calls.stream().map(c -> c.withModel(change.apply(c.model()))).toList());
  }

  /** A copy with other states and calls. */
  public SequenceSpec with(List<StateVariable> newStates, List<SequenceCall> newCalls) {
    return new SequenceSpec(length, order, repeat, threads, newStates, newCalls, events, line);
  }
}
