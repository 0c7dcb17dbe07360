package org.sitaf.core.combine.coverage;

/** Pseudo-random numbers that are the same on every machine for ever (SplitMix64). */
public final class Dice {
  private long state;

  /** Dice that fall the same way for the same seed. */
  public Dice(long seed) {
    this.state = seed;
  }

  private long next() {
    state += 0x9E3779B97F4A7C15L;
    long z = state;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** A number from 0 to {@code bound - 1}; {@code bound} is at least 1. */
  public int below(int bound) {
    return (int) (((next() >>> 32) * bound) >>> 32);
  }

  /** A number from 0 inclusive to 1 exclusive. */
  public double share() {
    return (next() >>> 11) * 0x1.0p-53;
  }

  /** Puts the items into an order of chance. */
  public void shuffle(int[] items) {
    for (int i = items.length - 1; i > 0; i--) {
      int j = below(i + 1);
      int item = items[i];
      items[i] = items[j];
      items[j] = item;
    }
  }

  /** Dice of their own, for another run with the same seed. */
  public Dice fork() {
    return new Dice(next());
  }
}
