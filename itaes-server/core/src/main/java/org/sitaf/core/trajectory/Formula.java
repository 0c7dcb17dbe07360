package org.sitaf.core.trajectory;

/** A formula of signal temporal logic over discrete samples. */
sealed interface Formula {
  /** The values at all samples in a lattice; the caller may change the array. */
  double[] values(Lattice lattice);

  /** The times after the first sample that the formula refers to at that sample. */
  Interval span();

  /**
   * A CEL expression that is true or false at each sample.
   *
   * @param index position in {@link ParsedFormula#atoms()}
   */
  record Atom(int index) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return lattice.atom(index);
    }

    @Override
    public Interval span() {
      return Interval.NOW;
    }
  }

  record Not(Formula operand) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return Lattice.negative(operand.values(lattice));
    }

    @Override
    public Interval span() {
      return operand.span();
    }
  }

  record And(Formula left, Formula right) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return Lattice.minimum(left.values(lattice), right.values(lattice));
    }

    @Override
    public Interval span() {
      return left.span().hull(right.span());
    }
  }

  record Or(Formula left, Formula right) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return Lattice.maximum(left.values(lattice), right.values(lattice));
    }

    @Override
    public Interval span() {
      return left.span().hull(right.span());
    }
  }

  record Implies(Formula left, Formula right) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return Lattice.maximum(Lattice.negative(left.values(lattice)), right.values(lattice));
    }

    @Override
    public Interval span() {
      return left.span().hull(right.span());
    }
  }

  /** An operator over all samples of an interval. */
  record Window(Quantifier quantifier, Interval interval, Formula operand) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return lattice.window(quantifier, interval, operand.values(lattice));
    }

    @Override
    public Interval span() {
      return quantifier.isFuture() ? interval : Interval.NOW;
    }
  }

  /** {@code left until right}: samples from now on. */
  record Until(Interval interval, Formula left, Formula right) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return lattice.until(interval, left.values(lattice), right.values(lattice));
    }

    @Override
    public Interval span() {
      return interval;
    }
  }

  /** {@code left since right}: samples up to now. */
  record Since(Interval interval, Formula left, Formula right) implements Formula {
    @Override
    public double[] values(Lattice lattice) {
      return lattice.since(interval, left.values(lattice), right.values(lattice));
    }

    @Override
    public Interval span() {
      return Interval.NOW;
    }
  }

  /** The operators with one operand. */
  enum Quantifier {
    ALWAYS(true, true),
    EVENTUALLY(false, true),
    HISTORICALLY(true, false),
    ONCE(false, false);

    private final boolean universal;
    private final boolean future;

    Quantifier(boolean universal, boolean future) {
      this.universal = universal;
      this.future = future;
    }

    /** Whether the operand must hold at all samples, rather than at one. */
    boolean isUniversal() {
      return universal;
    }

    /** Whether the interval extends into the future, rather than into the past. */
    boolean isFuture() {
      return future;
    }
  }
}
