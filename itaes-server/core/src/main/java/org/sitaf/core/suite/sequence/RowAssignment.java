package org.sitaf.core.suite.sequence;

import java.util.BitSet;
import java.util.List;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.sequence.CoveringWords;
import org.sitaf.core.sequence.Machine;
import org.sitaf.core.suite.sequence.PlannedCase.PlannedStep;
import org.sitaf.core.suite.sequence.PlannedCase.Role;

/** Gives each call of valid cases its values, so that every valid row is used. */
final class RowAssignment {
  private final StateSpace space;
  private final Machine machine;
  private final List<StepRows> rows;
  private final int length;
  private final boolean repeat;
  private final int[][] uses;

  RowAssignment(StateSpace space, List<StepRows> rows, int length, boolean repeat) {
    this.space = space;
    this.machine = space.machine();
    this.rows = rows;
    this.length = length;
    this.repeat = repeat;
    this.uses = rows.stream().map(r -> new int[r.choices().size()]).toArray(int[][]::new);
  }

  /** Records that rows are used by other cases. */
  void use(PlannedCase planned) {
    for (PlannedStep step : planned.steps()) {
      int at = rows.get(step.kind()).choices().indexOf(step.row());
      if (step.role() == Role.VALID && at >= 0) {
        uses[step.kind()][at]++;
      }
    }
  }

  /** A case of a word that the machine executes. */
  PlannedCase assign(int[] word) {
    return assign(machine, word, word.length);
  }

  /**
   * A case of the first steps of a word that a machine executes.
   *
   * @param extended the machine of the space, with further kinds of steps
   */
  PlannedCase assign(Machine extended, int[] word, int count) {
    BitSet[] from = extended.executableFrom(word);
    PlannedCase planned = new PlannedCase();
    int state = 0;
    for (int p = 0; p < count; p++) {
      int kind = word[p];
      List<StepRow> choices = rows.get(kind).choices();
      int best = -1;
      int next = -1;
      for (int r = 0; r < choices.size(); r++) {
        if (best >= 0 && rank(kind, r) >= rank(kind, best)) {
          continue;
        }
        int after = space.after(state, kind, choices.get(r));
        if (after >= 0 && from[p + 1].get(after)) {
          best = r;
          next = after;
        }
      }
      if (best < 0) {
        throw new IllegalStateException("no values execute step " + (p + 1));
      }
      uses[kind][best]++;
      planned.add(kind, choices.get(best), Role.VALID);
      state = next;
    }
    return planned;
  }

  /** Rows of the t-way suite come first, those that are used least before others. */
  private long rank(int kind, int row) {
    boolean isRequired = rows.get(kind).valid().contains(rows.get(kind).choices().get(row));
    return isRequired ? uses[kind][row] : Integer.MAX_VALUE + (long) uses[kind][row];
  }

  /** Adds steps, and cases where there is no room, until every valid row is used. */
  void complete(List<PlannedCase> cases, CoveringWords words) {
    for (int kind = 0; kind < rows.size(); kind++) {
      StepRows of = rows.get(kind);
      for (StepRow row : of.valid()) {
        int at = of.choices().indexOf(row);
        if (row.values().isEmpty() || uses[kind][at] > 0) {
          continue;
        }
        Interruption.check();
        if (insert(cases, kind, row) || append(cases, kind, row, words)) {
          uses[kind][at]++;
        }
      }
    }
  }

  private boolean insert(List<PlannedCase> cases, int kind, StepRow row) {
    for (PlannedCase planned : cases) {
      if (planned.steps().size() >= length || (!repeat && planned.contains(kind))) {
        continue;
      }
      int[] states = states(planned.steps());
      for (int p = planned.steps().size(); p >= 0; p--) {
        if (states[p] >= 0
            && machine.allows(states[p], kind)
            && executes(space.after(states[p], kind, row), planned.steps(), p)) {
          planned.steps().add(p, new PlannedStep(kind, row, Role.VALID));
          return true;
        }
      }
    }
    return false;
  }

  private boolean executes(int state, List<PlannedStep> steps, int from) {
    int at = state;
    for (int p = from; p < steps.size() && at >= 0; p++) {
      PlannedStep step = steps.get(p);
      at = machine.allows(at, step.kind()) ? space.after(at, step.kind(), step.row()) : -1;
    }
    return at >= 0;
  }

  /** The state before each step and after the last one; -1 where it is unknown. */
  private int[] states(List<PlannedStep> steps) {
    int[] states = new int[steps.size() + 1];
    for (int p = 0; p < steps.size(); p++) {
      PlannedStep step = steps.get(p);
      states[p + 1] = states[p] < 0 ? -1 : space.after(states[p], step.kind(), step.row());
    }
    return states;
  }

  /** A new case that reaches the call. */
  private boolean append(List<PlannedCase> cases, int kind, StepRow row, CoveringWords words) {
    int[] path = words.shortest(new int[] {kind});
    if (path == null) {
      return false;
    }
    PlannedCase planned = assign(path);
    List<PlannedStep> steps = planned.steps();
    steps.set(steps.size() - 1, new PlannedStep(kind, row, Role.VALID));
    cases.add(planned);
    return true;
  }
}
