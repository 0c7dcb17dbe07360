package org.sitaf.core.combine.search;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;

/** The remaining operations of a search. Counted instead of timed, so results are reproducible. */
public final class Budget {
  private final long total;
  private final @Nullable Budget source;
  private long left;
  private long stallLimit = Long.MAX_VALUE / 2;
  private long stallEnd = Long.MIN_VALUE;

  /** Creates a budget. */
  public Budget(long operations) {
    this(operations, null);
  }

  private Budget(long operations, @Nullable Budget source) {
    this.total = operations;
    this.left = operations;
    this.source = source;
  }

  /**
   * Spends operations; may exceed the remaining ones. Stops the search if its thread is
   * interrupted.
   */
  public void spend(long operations) {
    left -= operations;
    if (source != null) {
      source.spend(operations);
    } else {
      Interruption.check();
    }
  }

  /** Whether the budget is used up or there was no progress for too long. */
  public boolean isExhausted() {
    return left <= 0 || left < stallEnd;
  }

  /** Creates a part of this budget. Its operations are also spent here. */
  public Budget part(double share) {
    return new Budget(Math.min(remaining(), (long) (total * share)), this);
  }

  /**
   * Creates a budget of all remaining operations that is exhausted early if {@link #recordProgress}
   * is not called within a share of the total.
   */
  public Budget withStallLimit(double share) {
    Budget limited = new Budget(remaining(), this);
    limited.stallLimit = (long) (total * share);
    limited.recordProgress();
    return limited;
  }

  /** Restarts the stall limit. */
  public void recordProgress() {
    stallEnd = left - stallLimit;
  }

  /** The initial number of operations. */
  public long total() {
    return total;
  }

  /** The remaining number of operations. */
  public long remaining() {
    return Math.max(0, left);
  }

  /** The used share, 0 to 1. */
  public double share() {
    return total == 0 ? 1 : Math.min(1, 1 - (double) left / total);
  }
}
