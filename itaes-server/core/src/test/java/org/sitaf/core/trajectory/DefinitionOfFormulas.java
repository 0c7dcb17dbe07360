package org.sitaf.core.trajectory;

import java.util.List;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;

/**
 * Evaluates formulas literally by the definition of signal temporal logic over finite traces, in
 * exponential time. Shares no code with {@link Evaluator}.
 */
final class DefinitionOfFormulas {
  private final List<AtomValues> atoms;
  private final int count;
  private final long stepNanos;

  DefinitionOfFormulas(List<AtomValues> atoms, int count, long stepNanos) {
    this.atoms = atoms;
    this.count = count;
    this.stepNanos = stepNanos;
  }

  boolean holds(Formula formula) {
    Boolean truth = truth(formula, 0, count);
    if (truth == null) {
      throw new AssertionError("a complete trace decides each formula");
    }
    return truth;
  }

  double margin(Formula formula) {
    return margin(formula, 0);
  }

  /** The first sample with which the truth of the formula is known, whatever follows. */
  int decidedAt(Formula formula) {
    for (int known = 1; known <= count; known++) {
      if (truth(formula, 0, known - 1, false) != null) {
        return known - 1;
      }
    }
    return count - 1;
  }

  private boolean isWithin(Interval interval, int steps) {
    double seconds = steps * stepNanos / 1e9;
    return steps >= 0 && seconds >= interval.from() - 1e-9 && seconds <= interval.to() + 1e-9;
  }

  private double margin(Formula formula, int k) {
    if (formula instanceof Formula.Atom atom) {
      return atoms.get(atom.index()).margins()[k];
    } else if (formula instanceof Formula.Not not) {
      return -margin(not.operand(), k);
    } else if (formula instanceof Formula.And and) {
      return Math.min(margin(and.left(), k), margin(and.right(), k));
    } else if (formula instanceof Formula.Or or) {
      return Math.max(margin(or.left(), k), margin(or.right(), k));
    } else if (formula instanceof Formula.Implies implies) {
      return Math.max(-margin(implies.left(), k), margin(implies.right(), k));
    } else if (formula instanceof Formula.Window window) {
      boolean all = window.quantifier().isUniversal();
      double result = all ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
      for (int j = 0; j < count; j++) {
        if (isWithin(window.interval(), window.quantifier().isFuture() ? j - k : k - j)) {
          double value = margin(window.operand(), j);
          result = all ? Math.min(result, value) : Math.max(result, value);
        }
      }
      return result;
    } else if (formula instanceof Formula.Until until) {
      double result = Double.NEGATIVE_INFINITY;
      for (int j = k; j < count; j++) {
        if (isWithin(until.interval(), j - k)) {
          double value = margin(until.right(), j);
          for (int i = k; i < j; i++) {
            value = Math.min(value, margin(until.left(), i));
          }
          result = Math.max(result, value);
        }
      }
      return result;
    } else if (formula instanceof Formula.Since since) {
      double result = Double.NEGATIVE_INFINITY;
      for (int j = k; j >= 0; j--) {
        if (isWithin(since.interval(), k - j)) {
          double value = margin(since.right(), j);
          for (int i = k; i > j; i--) {
            value = Math.min(value, margin(since.left(), i));
          }
          result = Math.max(result, value);
        }
      }
      return result;
    }
    throw new AssertionError(formula);
  }

  private @Nullable Boolean truth(Formula formula, int k, int last) {
    return truth(formula, k, last, true);
  }

  /**
   * The truth at sample k if the samples up to {@code last} are known; null if it depends on the
   * others.
   *
   * @param ended whether the trace is known to end after its last sample
   */
  private @Nullable Boolean truth(Formula formula, int k, int last, boolean ended) {
    if (formula instanceof Formula.Atom atom) {
      return k > last ? null : atoms.get(atom.index()).truths()[k];
    } else if (formula instanceof Formula.Not not) {
      return not(truth(not.operand(), k, last, ended));
    } else if (formula instanceof Formula.And and) {
      return and(truth(and.left(), k, last, ended), truth(and.right(), k, last, ended));
    } else if (formula instanceof Formula.Or or) {
      return not(
          and(not(truth(or.left(), k, last, ended)), not(truth(or.right(), k, last, ended))));
    } else if (formula instanceof Formula.Implies implies) {
      return not(
          and(truth(implies.left(), k, last, ended), not(truth(implies.right(), k, last, ended))));
    } else if (formula instanceof Formula.Window window) {
      boolean all = window.quantifier().isUniversal();
      IntFunction<@Nullable Boolean> operand =
          j -> {
            Boolean truth = truth(window.operand(), j, last, ended);
            return all ? truth : not(truth);
          };
      Boolean result = true;
      if (window.quantifier().isFuture()) {
        for (int j = k; j < count; j++) {
          result = isWithin(window.interval(), j - k) ? and(result, operand.apply(j)) : result;
        }
        result = ended || !reachesBeyond(window.interval(), k) ? result : and(result, null);
      } else {
        for (int j = 0; j <= k; j++) {
          result = isWithin(window.interval(), k - j) ? and(result, operand.apply(j)) : result;
        }
      }
      return all ? result : not(result);
    } else if (formula instanceof Formula.Until until) {
      Boolean none = true;
      for (int j = k; j < count; j++) {
        if (isWithin(until.interval(), j - k)) {
          Boolean here = truth(until.right(), j, last, ended);
          for (int i = k; i < j; i++) {
            here = and(here, truth(until.left(), i, last, ended));
          }
          none = and(none, not(here));
        }
      }
      if (!ended && reachesBeyond(until.interval(), k)) {
        Boolean here = null;
        for (int i = k; i < count; i++) {
          here = and(here, truth(until.left(), i, last, ended));
        }
        none = and(none, not(here));
      }
      return not(none);
    } else if (formula instanceof Formula.Since since) {
      Boolean none = true;
      for (int j = k; j >= 0; j--) {
        if (isWithin(since.interval(), k - j)) {
          Boolean here = truth(since.right(), j, last, ended);
          for (int i = k; i > j; i--) {
            here = and(here, truth(since.left(), i, last, ended));
          }
          none = and(none, not(here));
        }
      }
      return not(none);
    }
    throw new AssertionError(formula);
  }

  /** Whether the interval, seen from sample k, holds a sample after the end of the trace. */
  private boolean reachesBeyond(Interval interval, int k) {
    for (int steps = count - k; steps < 10_000; steps++) {
      if (isWithin(interval, steps)) {
        return true;
      }
    }
    return false;
  }

  private static @Nullable Boolean not(@Nullable Boolean truth) {
    return truth == null ? null : Boolean.valueOf(!truth);
  }

  private static @Nullable Boolean and(@Nullable Boolean left, @Nullable Boolean right) {
    if (Boolean.FALSE.equals(left) || Boolean.FALSE.equals(right)) {
      return false;
    }
    return left == null || right == null ? null : Boolean.TRUE;
  }
}
