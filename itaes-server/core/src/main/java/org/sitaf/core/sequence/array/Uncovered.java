package org.sitaf.core.sequence.array;

import java.util.Arrays;
import java.util.function.IntPredicate;

/** How often each tuple occurs in the words of a search, and which required tuples do not. */
final class Uncovered {
  private final boolean[] required;
  private final int[] occurrences;
  private final int[] place;
  private final int[] members;
  private int size;

  /** Creates the counts of no words. */
  Uncovered(int tuples, IntPredicate isRequired) {
    this.required = new boolean[tuples];
    for (int tuple = 0; tuple < tuples; tuple++) {
      required[tuple] = isRequired.test(tuple);
    }
    this.occurrences = new int[tuples];
    this.place = new int[tuples];
    this.members = new int[tuples];
    clear();
  }

  /** Removes all words. */
  void clear() {
    Arrays.fill(occurrences, 0);
    Arrays.fill(place, -1);
    size = 0;
    for (int tuple = 0; tuple < required.length; tuple++) {
      if (required[tuple]) {
        place[tuple] = size;
        members[size++] = tuple;
      }
    }
  }

  /** Whether a tuple is required and does not occur. */
  boolean contains(int tuple) {
    return place[tuple] >= 0;
  }

  /** The number of required tuples that do not occur. */
  int size() {
    return size;
  }

  /** One of the required tuples that do not occur. */
  int member(int index) {
    return members[index];
  }

  void add(int tuple) {
    if (occurrences[tuple]++ == 0 && required[tuple]) {
      int at = place[tuple];
      int last = members[--size];
      members[at] = last;
      place[last] = at;
      place[tuple] = -1;
    }
  }

  void remove(int tuple) {
    if (--occurrences[tuple] == 0 && required[tuple]) {
      place[tuple] = size;
      members[size++] = tuple;
    }
  }
}
