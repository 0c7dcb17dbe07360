package org.sitaf.core.model;

/** Interaction strength t of a combination: every t-tuple of values occurs in at least one case. */
public record Strength(int t) {
  /** Maximum t in a document. */
  public static final int MAX = 6;

  /** Every combination of all values. */
  public static final Strength ALL = new Strength(Integer.MAX_VALUE);

  public Strength {
    if (t < 1 || (t > MAX && t != Integer.MAX_VALUE)) {
      throw new IllegalArgumentException("strength must be 1 to " + MAX + " or all, not " + t);
    }
  }

  /** Whether all combinations are generated. */
  public boolean isAll() {
    return t == Integer.MAX_VALUE;
  }

  /** The value in documents: a number, or {@code all}. */
  public String text() {
    return isAll() ? "all" : Integer.toString(t);
  }

  /**
   * Parses the value in a document.
   *
   * @throws IllegalArgumentException if it is neither 1 to 6 nor {@code all}
   */
  public static Strength parse(String text) {
    if (text.equals("all")) {
      return ALL;
    }
    try {
      return new Strength(Integer.parseInt(text));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "strength must be 1 to " + MAX + " or all, not '" + text + "'", e);
    }
  }
}
