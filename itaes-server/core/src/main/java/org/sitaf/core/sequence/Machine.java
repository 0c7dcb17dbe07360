package org.sitaf.core.sequence;

import java.util.BitSet;

/**
 * The abstract states that steps can reach. The values of a call may choose between several states
 * afterwards.
 */
public final class Machine {
  private final int[][][] successors;
  private final int kinds;

  /**
   * Creates a machine whose first state is the initial one.
   *
   * @param kinds number of kinds of steps
   * @param successors for each state and kind of step, the states afterwards; none if the step is
   *     not allowed
   */
  public Machine(int kinds, int[][][] successors) {
    this.kinds = kinds;
    this.successors = successors.clone();
  }

  /** A machine in which every step is always allowed. */
  public static Machine free(int kinds) {
    int[][] of = new int[kinds][];
    for (int kind = 0; kind < kinds; kind++) {
      of[kind] = new int[] {0};
    }
    return new Machine(kinds, new int[][][] {of});
  }

  /** The number of kinds of steps. */
  public int kinds() {
    return kinds;
  }

  /** The number of states. */
  public int states() {
    return successors.length;
  }

  /** Whether a step is allowed in a state. */
  public boolean allows(int state, int kind) {
    return successors[state][kind].length > 0;
  }

  /** The states after a step; none if it is not allowed. */
  public int[] after(int state, int kind) {
    return successors[state][kind];
  }

  /** Whether every step is allowed in every state. */
  public boolean isFree() {
    for (int[][] state : successors) {
      for (int[] after : state) {
        if (after.length == 0) {
          return false;
        }
      }
    }
    return true;
  }

  /** The set with only the initial state. */
  public BitSet initial() {
    BitSet set = new BitSet(states());
    set.set(0);
    return set;
  }

  /** The states that are possible after a step. */
  public BitSet after(BitSet states, int kind) {
    BitSet next = new BitSet(states());
    for (int s = states.nextSetBit(0); s >= 0; s = states.nextSetBit(s + 1)) {
      for (int after : successors[s][kind]) {
        next.set(after);
      }
    }
    return next;
  }

  /** The states in which the rest of a word, from a place on, can be executed. */
  public BitSet[] executableFrom(int[] word) {
    BitSet[] from = new BitSet[word.length + 1];
    from[word.length] = new BitSet(states());
    from[word.length].set(0, states());
    for (int p = word.length - 1; p >= 0; p--) {
      from[p] = new BitSet(states());
      for (int s = 0; s < states(); s++) {
        for (int after : successors[s][word[p]]) {
          if (from[p + 1].get(after)) {
            from[p].set(s);
          }
        }
      }
    }
    return from;
  }

  /**
   * Whether a word can be executed from the initial state.
   *
   * @param word kinds of steps; negative ones are left out
   */
  public boolean executes(int[] word) {
    BitSet states = initial();
    for (int kind : word) {
      if (kind >= 0) {
        states = after(states, kind);
        if (states.isEmpty()) {
          return false;
        }
      }
    }
    return true;
  }

  /** The least number of steps from each state to a state of a set; -1 if it cannot be reached. */
  public int[] distanceTo(BitSet goals) {
    int[] distance = new int[states()];
    java.util.Arrays.fill(distance, -1);
    for (int s = goals.nextSetBit(0); s >= 0; s = goals.nextSetBit(s + 1)) {
      distance[s] = 0;
    }
    boolean changed = true;
    for (int d = 1; changed; d++) {
      changed = false;
      for (int s = 0; s < distance.length; s++) {
        if (distance[s] < 0 && leadsTo(s, distance, d - 1)) {
          distance[s] = d;
          changed = true;
        }
      }
    }
    return distance;
  }

  private boolean leadsTo(int state, int[] distance, int wanted) {
    for (int[] kind : successors[state]) {
      for (int after : kind) {
        if (distance[after] == wanted) {
          return true;
        }
      }
    }
    return false;
  }
}
