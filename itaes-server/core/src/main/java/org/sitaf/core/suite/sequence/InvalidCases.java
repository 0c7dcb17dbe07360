package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.sequence.CoveringWords;
import org.sitaf.core.sequence.Machine;
import org.sitaf.core.sequence.array.TupleSpace;
import org.sitaf.core.suite.sequence.PlannedCase.Role;

/** Plans the cases with a forbidden call or an invalid row: one of these in each. */
final class InvalidCases {
  private final StateSpace space;
  private final List<CompiledStep> steps;
  private final List<StepRows> rows;
  private final RowAssignment assignment;
  private final int length;
  private final int order;
  private final boolean repeat;
  private final long seed;

  InvalidCases(
      StateSpace space,
      List<CompiledStep> steps,
      List<StepRows> rows,
      int length,
      int order,
      boolean repeat,
      long seed) {
    this.space = space;
    this.steps = steps;
    this.rows = rows;
    this.assignment = new RowAssignment(space, rows, length, repeat);
    this.length = length;
    this.order = order;
    this.repeat = repeat;
    this.seed = seed;
  }

  /** The calls of a step where its guard is false, after each (t-1)-tuple where it can be. */
  List<PlannedCase> forbidden(int call) {
    BitSet guarded = new BitSet();
    for (int s = 0; s < space.size(); s++) {
      guarded.set(s, !steps.get(call).isAllowed(space.state(s)));
    }
    BitSet followed = (BitSet) guarded.clone();
    for (int s = guarded.nextSetBit(0); s >= 0; s = guarded.nextSetBit(s + 1)) {
      followed.set(s, followUp(call, space.state(s), null, List.of()).isPresent());
    }
    List<PlannedCase> cases = new ArrayList<>();
    TupleSpace tuples = new TupleSpace(steps.size() + 1, order);
    BitSet done = new BitSet();
    if (length > 1) {
      done = forbidden(call, followed, length - 1, tuples, done, cases);
    }
    forbidden(call, guarded, length, tuples, done, cases);
    return cases;
  }

  /** Adds the cases of the tuples that are possible and not done; returns those that are done. */
  private BitSet forbidden(
      int call, BitSet where, int most, TupleSpace tuples, BitSet done, List<PlannedCase> cases) {
    CoveringWords words = new CoveringWords(withForbidden(call, where), tuples, most, repeat);
    BitSet required = words.allowed();
    for (int t = required.nextSetBit(0); t >= 0; t = required.nextSetBit(t + 1)) {
      required.set(t, t % tuples.letters() == steps.size() && !done.get(t));
    }
    int number = 0;
    for (int[] word : words.cover(required, Effort.FAST, seed, Progress.NONE)) {
      cases.add(forbidden(call, word, where, number++));
    }
    required.or(done);
    return required;
  }

  private PlannedCase forbidden(int call, int[] word, BitSet where, int number) {
    // The last step is the forbidden one; the path before it ends where the guard is false.
    int[] path = Arrays.copyOf(word, word.length - 1);
    PlannedCase planned = assignTo(path, where);
    List<StepRow> valid = rows.get(call).valid();
    planned.add(call, valid.get(number % valid.size()), Role.FORBIDDEN);
    follow(planned, last(planned), null);
    return planned;
  }

  /** Values with which a path ends in a state of a set. */
  private PlannedCase assignTo(int[] path, BitSet goals) {
    Machine marked = marked(goals);
    int[] word = Arrays.copyOf(path, path.length + 1);
    word[path.length] = steps.size();
    return assignment.assign(marked, word, path.length);
  }

  /** The machine with a further kind of step that is possible in some states. */
  private Machine marked(BitSet where) {
    return with(where, -1);
  }

  private Machine withForbidden(int call, BitSet where) {
    return with(where, repeat ? -1 : call);
  }

  private Machine with(BitSet where, int without) {
    Machine machine = space.machine();
    int end = space.size();
    int[][][] successors = new int[end + 1][steps.size() + 1][];
    for (int s = 0; s <= end; s++) {
      for (int kind = 0; kind < steps.size(); kind++) {
        successors[s][kind] = s == end || kind == without ? new int[0] : machine.after(s, kind);
      }
      successors[s][steps.size()] = s < end && where.get(s) ? new int[] {end} : new int[0];
    }
    return new Machine(steps.size() + 1, successors);
  }

  /** A case with an invalid row of a call, where its guard is true; empty if there is none. */
  Optional<PlannedCase> invalidRow(int call, StepRow row) {
    Interruption.check();
    Machine machine = space.machine();
    BitSet allowed = new BitSet();
    BitSet followed = new BitSet();
    for (int s = 0; s < space.size(); s++) {
      if (machine.allows(s, call)) {
        allowed.set(s);
        AbstractState state = space.state(s);
        followed.set(s, followUp(call, state, other(call, state, row), List.of()).isPresent());
      }
    }
    TupleSpace tuples = new TupleSpace(steps.size() + 1, 1);
    int[] word = length > 1 ? path(call, followed, length - 1, tuples) : null;
    BitSet where = word == null ? allowed : followed;
    if (word == null) {
      word = path(call, allowed, length, tuples);
    }
    if (word == null) {
      return Optional.empty();
    }
    PlannedCase planned = assignTo(Arrays.copyOf(word, word.length - 1), where);
    AbstractState state = last(planned);
    planned.add(call, row, Role.INVALID_ROW);
    follow(planned, state, other(call, state, row));
    return Optional.of(planned);
  }

  private int @Nullable [] path(int call, BitSet where, int most, TupleSpace tuples) {
    return new CoveringWords(withForbidden(call, where), tuples, most, repeat)
        .shortest(new int[] {steps.size()});
  }

  /** The state after an invalid row, if it may differ; null if it stays or is not defined. */
  private @Nullable AbstractState other(int call, AbstractState state, StepRow row) {
    CompiledStep step = steps.get(call);
    if (CompiledStep.isError(step.expected(state, 1, row))) {
      return null;
    }
    try {
      return step.after(state, row);
    } catch (StepException e) {
      return null;
    }
  }

  /** The state after the last step, all of which have valid values. */
  private AbstractState last(PlannedCase planned) {
    int state = 0;
    for (PlannedCase.PlannedStep step : planned.steps()) {
      if (step.role() == Role.VALID) {
        state = space.after(state, step.kind(), step.row());
      }
    }
    return space.state(state);
  }

  private void follow(PlannedCase planned, AbstractState state, @Nullable AbstractState other) {
    if (planned.steps().size() >= length) {
      return;
    }
    List<Integer> used = planned.steps().stream().map(PlannedCase.PlannedStep::kind).toList();
    followUp(used.get(used.size() - 1), state, other, used)
        .ifPresent(kind -> planned.add(kind, rows.get(kind).valid().get(0), Role.VALID));
  }

  /** A step that is allowed in a state and in the other one: the same call, else the first. */
  private Optional<Integer> followUp(
      int call, AbstractState state, @Nullable AbstractState other, List<Integer> used) {
    return IntStream.concat(IntStream.of(call), IntStream.range(0, steps.size()))
        .filter(kind -> repeat || (kind != call && !used.contains(kind)))
        .filter(kind -> steps.get(kind).isAllowed(state))
        .filter(kind -> other == null || steps.get(kind).isAllowed(other))
        .boxed()
        .findFirst();
  }
}
