package org.sitaf.core.sequence.array;

import java.math.BigInteger;
import org.sitaf.core.combine.TooManyCombinationsException;

/** All t-tuples of letters 0 to n-1, numbered as the digits of a number to the base n. */
public final class TupleSpace {
  /** Maximum number of tuples; a search keeps some bytes for each. */
  private static final int MAX_TUPLES = 4_000_000;

  private final int letters;
  private final int strength;
  private final int size;

  /**
   * Creates the space.
   *
   * @throws TooManyCombinationsException if there are too many tuples
   */
  public TupleSpace(int letters, int strength) {
    BigInteger all = BigInteger.valueOf(letters).pow(strength);
    if (all.compareTo(BigInteger.valueOf(MAX_TUPLES)) > 0) {
      throw new TooManyCombinationsException(
          strength + "-tuples of " + letters + " steps", all, MAX_TUPLES);
    }
    this.letters = letters;
    this.strength = strength;
    this.size = all.intValueExact();
  }

  /** The number of letters. */
  public int letters() {
    return letters;
  }

  /** The number of letters in a tuple. */
  public int strength() {
    return strength;
  }

  /** The number of tuples, including those in which a letter repeats. */
  public int size() {
    return size;
  }

  /** The letters of a tuple. */
  public int[] letters(int tuple) {
    int[] found = new int[strength];
    int rest = tuple;
    for (int i = strength - 1; i >= 0; i--) {
      found[i] = rest % letters;
      rest /= letters;
    }
    return found;
  }

  /** The number of a tuple. */
  public int index(int... tuple) {
    int index = 0;
    for (int letter : tuple) {
      index = index * letters + letter;
    }
    return index;
  }

  /** Whether no letter occurs twice. */
  public boolean isDistinct(int tuple) {
    int[] found = letters(tuple);
    for (int i = 1; i < found.length; i++) {
      for (int j = 0; j < i; j++) {
        if (found[i] == found[j]) {
          return false;
        }
      }
    }
    return true;
  }
}
