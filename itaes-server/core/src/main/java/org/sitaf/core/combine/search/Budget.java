package org.sitaf.core.combine.search;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;

/** What a search may still spend, in word operations: a count, never the clock. */
public final class Budget {
  private final long whole;
  private final @Nullable Budget source;
  private long left;
  private long patience = Long.MAX_VALUE / 2;
  private long goodUntil = Long.MIN_VALUE;

  /** So many word operations. */
  public Budget(long operations) {
    this(operations, null);
  }

  private Budget(long operations, @Nullable Budget source) {
    this.whole = operations;
    this.left = operations;
    this.source = source;
  }

  /** Spends some; more than is left is possible once. Ends the search of an interrupted thread. */
  public void spend(long operations) {
    left -= operations;
    if (source != null) {
      source.spend(operations);
    } else {
      Interruption.check();
    }
  }

  /** Whether nothing is left. */
  public boolean spent() {
    return left <= 0 || left < goodUntil;
  }

  /** A share of the whole, as far as it is left; spent here when it is spent there. */
  public Budget part(double share) {
    return new Budget(Math.min(left(), (long) (whole * share)), this);
  }

  /** All that is left, but spent as soon as this share of the whole brings no {@link #renew}. */
  public Budget patient(double share) {
    Budget patient = new Budget(left(), this);
    patient.patience = (long) (whole * share);
    patient.renew();
    return patient;
  }

  /** Something was found: patience begins anew. */
  public void renew() {
    goodUntil = left - patience;
  }

  /** What there was to spend. */
  public long whole() {
    return whole;
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
