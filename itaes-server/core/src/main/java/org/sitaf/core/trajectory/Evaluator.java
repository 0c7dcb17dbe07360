package org.sitaf.core.trajectory;

import java.util.List;
import org.sitaf.core.trajectory.Formula.Quantifier;

/** Evaluates a formula at the first sample of a finite trace. */
final class Evaluator {
  private final List<AtomValues> atoms;
  private final int count;
  private final long stepNanos;

  /**
   * Creates an evaluator.
   *
   * @param atoms the values of each atom, with the same number of samples
   * @param count the number of samples, above 0
   */
  Evaluator(List<AtomValues> atoms, int count, long stepNanos) {
    this.atoms = List.copyOf(atoms);
    this.count = count;
    this.stepNanos = stepNanos;
  }

  Robustness evaluate(Formula formula) {
    double margin = formula.values(Lattice.ofMargins(atoms, count, stepNanos))[0];
    double decision = formula.values(Lattice.ofDecisions(atoms, count, stepNanos))[0];
    int sample = count + 1 - (int) Math.abs(decision);
    // Adding 0 makes a negative zero positive.
    return new Robustness(decision > 0, margin + 0.0, Math.min(count - 1, sample));
  }

  /** Index of the atom that decides the truth value; -1 if only the end of the trace does. */
  int decidingAtom(Formula formula) {
    Lattice decisions = Lattice.ofDecisions(atoms, count, stepNanos);
    double decision = formula.values(decisions)[0];
    return Math.abs(decision) == 1 ? -1 : decidingAtom(formula, 0, decision, decisions);
  }

  private static int decidingAtom(Formula formula, int k, double decision, Lattice decisions) {
    if (formula instanceof Formula.Atom atom) {
      return atom.index();
    } else if (formula instanceof Formula.Not not) {
      return decidingAtom(not.operand(), k, -decision, decisions);
    } else if (formula instanceof Formula.And and) {
      return decidingAtom(List.of(and.left(), and.right()), k, k, decision, decisions);
    } else if (formula instanceof Formula.Or or) {
      return decidingAtom(List.of(or.left(), or.right()), k, k, decision, decisions);
    } else if (formula instanceof Formula.Implies implies) {
      List<Formula> disjunction = List.of(implies.right(), new Formula.Not(implies.left()));
      return decidingAtom(disjunction, k, k, decision, decisions);
    } else if (formula instanceof Formula.Window window) {
      int first = decisions.first(window.interval());
      int last = decisions.last(window.interval());
      Quantifier quantifier = window.quantifier();
      return decidingAtom(
          List.of(window.operand()),
          quantifier.isFuture() ? k + first : k - last,
          quantifier.isFuture() ? k + last : k - first,
          decision,
          decisions);
    } else if (formula instanceof Formula.Until until) {
      List<Formula> operands = List.of(until.left(), until.right());
      return decidingAtom(operands, k, decisions.count() - 1, decision, decisions);
    } else if (formula instanceof Formula.Since since) {
      return decidingAtom(List.of(since.left(), since.right()), 0, k, decision, decisions);
    }
    return -1;
  }

  /** Searches operands with this decision from sample {@code from} to sample {@code to}. */
  private static int decidingAtom(
      List<Formula> operands, int from, int to, double decision, Lattice decisions) {
    for (Formula operand : operands) {
      double[] values = operand.values(decisions);
      for (int j = Math.max(0, from); j <= Math.min(to, values.length - 1); j++) {
        if (values[j] == decision) {
          return decidingAtom(operand, j, decision, decisions);
        }
      }
    }
    return -1;
  }
}
