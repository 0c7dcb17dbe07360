package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.sequence.Machine;

/** The abstract states that sequences of limited length can reach. */
final class StateSpace {
  private static final int MAX_STATES = 5_000;
  private static final long MAX_EVALUATIONS = 20_000_000;

  private final List<CompiledStep> steps;
  private final List<StepRows> rows;
  private final boolean numbered;
  private final List<Numbered> states = new ArrayList<>();
  private final Map<Numbered, Integer> index = new HashMap<>();
  private final Machine machine;

  /**
   * A state and, if it matters, the number of the next step.
   *
   * @param number 0 if it does not matter
   */
  private record Numbered(AbstractState state, int number) {}

  /**
   * Explores the states.
   *
   * @param rows of each step
   * @throws IllegalStateException if there are too many, with numbers
   */
  StateSpace(AbstractState initial, List<CompiledStep> steps, List<StepRows> rows, int length) {
    this.steps = steps;
    this.rows = rows;
    this.numbered = steps.stream().anyMatch(CompiledStep::dependsOnNumber);
    this.machine = explore(initial, length);
  }

  private Machine explore(AbstractState initial, int length) {
    List<int[][]> successors = new ArrayList<>();
    indexOf(new Numbered(initial, numbered ? 1 : 0));
    long evaluations = 0;
    int from = 0;
    for (int depth = 0; depth < length && from < states.size(); depth++) {
      int to = states.size();
      for (; from < to; from++) {
        Interruption.check();
        int[][] of = new int[steps.size()][];
        for (int kind = 0; kind < steps.size(); kind++) {
          of[kind] = explore(from, kind);
          evaluations += rows.get(kind).choices().size();
        }
        successors.add(of);
        if (states.size() > MAX_STATES || evaluations > MAX_EVALUATIONS) {
          throw new IllegalStateException(
              String.format(
                  Locale.ROOT,
                  "more than %,d abstract states or %,d combinations of states and values are"
                      + " possible after %d of %d steps; use fewer state variables or values, or"
                      + " reduce length",
                  Math.min(MAX_STATES, states.size() - 1),
                  Math.min(MAX_EVALUATIONS, evaluations),
                  depth + 1,
                  length));
        }
      }
    }
    while (successors.size() < states.size()) {
      // After the last step; nothing follows.
      int[][] none = new int[steps.size()][];
      java.util.Arrays.fill(none, new int[0]);
      successors.add(none);
    }
    return new Machine(steps.size(), successors.toArray(int[][][]::new));
  }

  private int[] explore(int state, int kind) {
    if (!steps.get(kind).isAllowed(states.get(state).state())) {
      return new int[0];
    }
    TreeSet<Integer> after = new TreeSet<>();
    for (StepRow row : choices(kind)) {
      after.add(indexOf(next(states.get(state), kind, row)));
    }
    return after.stream().mapToInt(Integer::intValue).toArray();
  }

  /** One row is enough if the values do not matter for the state. */
  private List<StepRow> choices(int kind) {
    CompiledStep step = steps.get(kind);
    List<StepRow> choices = rows.get(kind).choices();
    return step.step().updates().isEmpty() || step.relevantInputs().isEmpty()
        ? choices.subList(0, Math.min(1, choices.size()))
        : choices;
  }

  private Numbered next(Numbered before, int kind, StepRow row) {
    CompiledStep step = steps.get(kind);
    boolean leaves =
        !step.step().updates().isEmpty()
            && CompiledStep.isError(step.expected(before.state(), before.number(), row));
    AbstractState after = leaves ? before.state() : step.after(before.state(), row);
    return new Numbered(after, numbered ? before.number() + 1 : 0);
  }

  private int indexOf(Numbered state) {
    return index.computeIfAbsent(
        state,
        s -> {
          states.add(s);
          return states.size() - 1;
        });
  }

  Machine machine() {
    return machine;
  }

  AbstractState state(int at) {
    return states.get(at).state();
  }

  int size() {
    return states.size();
  }

  /** The state after a call with a row; -1 if it is unknown. */
  int after(int state, int kind, StepRow row) {
    return index.getOrDefault(next(states.get(state), kind, row), -1);
  }
}
