package org.sitaf.core.model;

/** Interaction strength t of a combination: every t-tuple of values occurs in a case. */
public record Strength(int t) {
  /** The largest t that a document may name. */
  public static final int MAX = 6;

  /** Every combination of all values. */
  public static final Strength ALL = new Strength(Integer.MAX_VALUE);

  public Strength {
    if (t < 1 || (t > MAX && t != Integer.MAX_VALUE)) {
      throw new IllegalArgumentException("strength must be 1 to " + MAX + " or all, not " + t);
    }
  }

  /** Whether every combination is wanted. */
  public boolean isAll() {
    return t == Integer.MAX_VALUE;
  }

  /** As documents spell it: the number, or {@code all}. */
  public String spelling() {
    return isAll() ? "all" : Integer.toString(t);
  }

  /**
   * Reads the spelling of a document.
   *
   * @throws IllegalArgumentException when it is neither 1 to 6 nor {@code all}
   */
  public static Strength parse(String spelling) {
    if (spelling.equals("all")) {
      return ALL;
    }
    try {
      return new Strength(Integer.parseInt(spelling));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "strength must be 1 to " + MAX + " or all, not '" + spelling + "'", e);
    }
  }
}
