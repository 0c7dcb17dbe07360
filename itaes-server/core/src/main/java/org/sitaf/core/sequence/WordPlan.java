package org.sitaf.core.sequence;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.combine.Interruption;

/**
 * Finds a shortest continuation of a word that contains the rest of a tuple as a subsequence.
 * Without repetition, the search also knows which steps are used; then it may be large and is
 * bounded.
 */
final class WordPlan {
  private final Machine machine;
  private final boolean repeat;
  private final long limit;
  private long explored;

  /**
   * @param limit maximum number of explored places of all searches without repetition
   */
  WordPlan(Machine machine, boolean repeat, long limit) {
    this.machine = machine;
    this.repeat = repeat;
    this.limit = limit;
  }

  /** A place in a search: what is matched, where, and with which used steps. */
  private record Place(int matched, int state, BitSet used) {}

  private record Visit(Place place, int kind, int depth, Visit before) {}

  /**
   * A shortest continuation.
   *
   * @param states the possible states now
   * @param used the kinds of steps of the word so far
   * @param rest what remains of the tuple
   * @param most maximum number of steps
   * @throws TooLargeException if the search is too large
   */
  Optional<List<Integer>> shortest(BitSet states, BitSet used, int[] rest, int most) {
    Interruption.check();
    if (!repeat && Arrays.stream(rest).anyMatch(used::get)) {
      return Optional.empty();
    }
    BitSet reserved = new BitSet();
    if (!repeat) {
      Arrays.stream(rest).forEach(reserved::set);
    }
    BitSet first = repeat ? new BitSet() : used;
    Deque<Visit> open = new ArrayDeque<>();
    Set<Place> seen = new HashSet<>();
    for (int s = states.nextSetBit(0); s >= 0; s = states.nextSetBit(s + 1)) {
      Place place = new Place(0, s, first);
      seen.add(place);
      open.add(new Visit(place, -1, 0, null));
    }
    while (!open.isEmpty()) {
      Visit visit = open.poll();
      Place at = visit.place();
      if (at.matched() == rest.length) {
        return Optional.of(path(visit));
      }
      if (visit.depth() + rest.length - at.matched() > most) {
        continue;
      }
      if (!repeat && ++explored > limit) {
        throw new TooLargeException(limit);
      }
      for (int kind = 0; kind < machine.kinds(); kind++) {
        boolean matches = rest[at.matched()] == kind;
        if (!repeat && !matches && (at.used().get(kind) || reserved.get(kind))) {
          continue;
        }
        for (int to : machine.after(at.state(), kind)) {
          BitSet then = at.used();
          if (!repeat) {
            then = (BitSet) then.clone();
            then.set(kind);
          }
          Place place = new Place(at.matched() + (matches ? 1 : 0), to, then);
          if (seen.add(place)) {
            open.add(new Visit(place, kind, visit.depth() + 1, visit));
          }
        }
      }
    }
    return Optional.empty();
  }

  private static List<Integer> path(Visit last) {
    List<Integer> kinds = new ArrayList<>();
    for (Visit v = last; v.before() != null; v = v.before()) {
      kinds.add(v.kind());
    }
    Collections.reverse(kinds);
    return kinds;
  }

  /** Thrown if it cannot be decided within the limit whether a tuple is possible. */
  static final class TooLargeException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooLargeException(long limit) {
      super(
          String.format(
              java.util.Locale.ROOT,
              "more than %,d combinations of used steps and states; write repeat=\"true\", or"
                  + " reduce the number of steps",
              limit));
    }
  }
}
