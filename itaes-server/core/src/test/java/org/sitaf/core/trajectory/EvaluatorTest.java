package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sitaf.core.trajectory.Formula.Quantifier;

class EvaluatorTest {
  private static final long STEP_NANOS = 100_000_000;

  @Test
  void randomFormulasAreEvaluatedAsDefined() {
    for (int seed = 0; seed < 2_000; seed++) {
      Random random = new Random(seed);
      int count = 1 + random.nextInt(9);
      List<AtomValues> atoms = List.of(atom(random, count), atom(random, count));
      Formula formula = formula(random, 3);
      DefinitionOfFormulas definition = new DefinitionOfFormulas(atoms, count, STEP_NANOS);

      Robustness actual = new Evaluator(atoms, count, STEP_NANOS).evaluate(formula);

      assertThat(actual)
          .as("seed %d: %s over %d samples", seed, formula, count)
          .isEqualTo(
              new Robustness(
                  definition.holds(formula),
                  definition.margin(formula) + 0.0,
                  definition.decidedAt(formula)));
    }
  }

  // The examples of nickovic/rtamt issue 210, where dense-time until and since answer -0.5.

  @Test
  void untilHoldsWhenOneConditionReplacesTheOtherAtOneSample() {
    double[] signal = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    List<AtomValues> atoms = List.of(below(signal, 0.5), atLeast(signal, 0.5));
    Formula until = new Formula.Until(new Interval(0, 1), new Formula.Atom(0), new Formula.Atom(1));

    assertThat(new Evaluator(atoms, signal.length, STEP_NANOS).evaluate(until))
        .isEqualTo(new Robustness(true, 0.5, 5));
  }

  @Test
  void sinceHoldsWhenOneConditionReplacesTheOtherAtOneSample() {
    double[] signal = {1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};
    List<AtomValues> atoms = List.of(below(signal, 0.5), atLeast(signal, 0.5));
    Formula since = new Formula.Since(Interval.UNBOUNDED, new Formula.Atom(0), new Formula.Atom(1));

    assertThat(
            new Evaluator(atoms, signal.length, STEP_NANOS)
                .evaluate(new Formula.Window(Quantifier.ALWAYS, Interval.UNBOUNDED, since)))
        .isEqualTo(new Robustness(true, 0.5, 10));
  }

  @Test
  void untilIsViolatedWhenTheFirstConditionEndsOneSampleTooEarly() {
    double[] left = {0, 0, 1, 0, 0};
    double[] right = {0, 0, 0, 1, 1};
    List<AtomValues> atoms = List.of(below(left, 0.5), atLeast(right, 0.5));
    Formula until = new Formula.Until(new Interval(0, 1), new Formula.Atom(0), new Formula.Atom(1));

    assertThat(new Evaluator(atoms, 5, STEP_NANOS).evaluate(until))
        .isEqualTo(new Robustness(false, -0.5, 2));
  }

  @Test
  void boundsOfIntervalsTolerateRounding() {
    // 0.1 + 0.2 is above 0.3, and 3 * 0.1 is, too.
    Interval interval = new Interval(0.3, 0.1 + 0.2);

    assertThat(interval.firstStep(STEP_NANOS)).isEqualTo(3);
    assertThat(interval.lastStep(STEP_NANOS)).isEqualTo(3);
    assertThat(new Interval(0.301, 0.399).firstStep(STEP_NANOS)).isEqualTo(4);
    assertThat(new Interval(0.301, 0.399).lastStep(STEP_NANOS)).isEqualTo(3);
    assertThat(new Interval(1e300, 1e301).firstStep(STEP_NANOS))
        .isEqualTo(Interval.UNBOUNDED_STEPS);
  }

  @Test
  void longTracesTakeLinearTime() {
    int count = 1_000_000;
    double[] signal = new double[count];
    for (int k = 0; k < count; k++) {
      signal[k] = Math.sin(k * 0.001);
    }
    Formula formula =
        new Formula.Window(
            Quantifier.ALWAYS,
            new Interval(0, 50_000),
            new Formula.Window(
                Quantifier.EVENTUALLY, new Interval(0, 20_000), new Formula.Atom(0)));

    assertThat(
            new Evaluator(List.of(atLeast(signal, 0.9)), count, STEP_NANOS)
                .evaluate(formula)
                .holds())
        .isTrue();
  }

  private static AtomValues below(double[] signal, double limit) {
    boolean[] truths = new boolean[signal.length];
    double[] margins = new double[signal.length];
    for (int k = 0; k < signal.length; k++) {
      truths[k] = signal[k] < limit;
      margins[k] = limit - signal[k];
    }
    return new AtomValues(truths, margins);
  }

  private static AtomValues atLeast(double[] signal, double limit) {
    AtomValues below = below(signal, limit);
    boolean[] truths = new boolean[signal.length];
    double[] margins = new double[signal.length];
    for (int k = 0; k < signal.length; k++) {
      truths[k] = !below.truths()[k];
      margins[k] = -below.margins()[k];
    }
    return new AtomValues(truths, margins);
  }

  /** Truths with margins that are sometimes zero or infinite. */
  private static AtomValues atom(Random random, int count) {
    boolean[] truths = new boolean[count];
    double[] margins = new double[count];
    for (int k = 0; k < count; k++) {
      truths[k] = random.nextBoolean();
      double distance =
          switch (random.nextInt(6)) {
            case 0 -> 0;
            case 1 -> Double.POSITIVE_INFINITY;
            default -> random.nextInt(20) / 4.0;
          };
      margins[k] = truths[k] ? distance : -distance;
    }
    return new AtomValues(truths, margins);
  }

  private static Formula formula(Random random, int depth) {
    if (depth == 0) {
      return new Formula.Atom(random.nextInt(2));
    }
    Formula left = formula(random, depth - 1 - random.nextInt(depth));
    return switch (random.nextInt(9)) {
      case 0 -> new Formula.Not(left);
      case 1 -> new Formula.And(left, formula(random, depth - 1));
      case 2 -> new Formula.Or(left, formula(random, depth - 1));
      case 3 -> new Formula.Implies(left, formula(random, depth - 1));
      case 4 -> new Formula.Until(interval(random), left, formula(random, depth - 1));
      case 5 -> new Formula.Since(interval(random), left, formula(random, depth - 1));
      default ->
          new Formula.Window(
              Quantifier.values()[random.nextInt(4)], interval(random), formula(random, depth - 1));
    };
  }

  /** Bounds on samples and between them, also beyond the end and without any sample. */
  private static Interval interval(Random random) {
    if (random.nextInt(4) == 0) {
      return Interval.UNBOUNDED;
    }
    double from = random.nextInt(2) == 0 ? 0 : random.nextInt(24) * 0.05;
    return new Interval(
        from, random.nextInt(5) == 0 ? Double.POSITIVE_INFINITY : from + random.nextInt(16) * 0.05);
  }
}
