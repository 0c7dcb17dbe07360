package org.sitaf.core.sequence;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.sequence.array.TupleSpace;

/**
 * Finds the tuples that some executable word of limited length contains as a subsequence, by the
 * least number of steps that each state needs after a part of the tuple.
 */
final class AllowedTuples {
  private static final int NEVER = Integer.MAX_VALUE;

  private final Machine machine;
  private final int length;
  private final Map<List<Integer>, Integer> known = new HashMap<>();
  private final List<int[]> costs = new ArrayList<>();
  private final List<int[]> next = new ArrayList<>();

  private AllowedTuples(Machine machine, int length) {
    this.machine = machine;
    this.length = length;
  }

  /** The allowed tuples if steps may repeat. */
  static BitSet of(Machine machine, TupleSpace space, int length) {
    AllowedTuples search = new AllowedTuples(machine, length);
    int[] start = new int[machine.states()];
    Arrays.fill(start, NEVER);
    start[0] = 0;
    BitSet allowed = new BitSet(space.size());
    search.collect(search.idOf(start), 0, space.strength(), allowed);
    return allowed;
  }

  private void collect(int id, int tuple, int left, BitSet allowed) {
    if (left == 0) {
      allowed.set(tuple);
      return;
    }
    Interruption.check();
    for (int kind = 0; kind < machine.kinds(); kind++) {
      int after = after(id, kind);
      if (after >= 0) {
        collect(after, tuple * machine.kinds() + kind, left - 1, allowed);
      }
    }
  }

  /** The costs after further steps of which the last is of this kind; -1 if it is impossible. */
  private int after(int id, int kind) {
    int[] of = next.get(id);
    if (of[kind] == NEVER) {
      int[] before = costs.get(id);
      int[] after = new int[before.length];
      Arrays.fill(after, NEVER);
      boolean possible = false;
      for (int s = 0; s < before.length; s++) {
        if (before[s] < length) {
          for (int to : machine.after(s, kind)) {
            after[to] = Math.min(after[to], before[s] + 1);
            possible = true;
          }
        }
      }
      of[kind] = possible ? idOf(after) : -1;
    }
    return of[kind];
  }

  /** Adds what further steps reach, and gives equal costs one number. */
  private int idOf(int[] given) {
    int[] closed = given.clone();
    for (int step = 0; step < length; step++) {
      for (int s = 0; s < closed.length; s++) {
        if (closed[s] == step) {
          for (int kind = 0; kind < machine.kinds(); kind++) {
            for (int to : machine.after(s, kind)) {
              closed[to] = Math.min(closed[to], step + 1);
            }
          }
        }
      }
    }
    return known.computeIfAbsent(
        Arrays.stream(closed).boxed().toList(),
        c -> {
          int[] unknown = new int[machine.kinds()];
          Arrays.fill(unknown, NEVER);
          costs.add(closed);
          next.add(unknown);
          return costs.size() - 1;
        });
  }
}
