package org.sitaf.core.combine.search;

/** What a search may still spend, in word operations: a count, never the clock. */
public final class Budget {
  private final long whole;
  private long left;

  /** So many word operations. */
  public Budget(long operations) {
    this.whole = operations;
    this.left = operations;
  }

  /** Spends some; more than is left is possible once. */
  public void spend(long operations) {
    left -= operations;
  }

  /** Whether nothing is left. */
  public boolean spent() {
    return left <= 0;
  }

  /** What is left. */
  public long left() {
    return Math.max(0, left);
  }

  /** How much of the whole is spent, 0 to 1. */
  public double share() {
    return whole == 0 ? 1 : Math.min(1, 1 - (double) left / whole);
  }
}
