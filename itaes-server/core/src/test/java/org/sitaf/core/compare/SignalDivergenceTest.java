package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sitaf.core.trajectory.Trace;

class SignalDivergenceTest {
  private static final long STEP = 10_000_000;

  private static Trace trace(long first, double[] x, double[] y) {
    return new Trace(first, STEP, List.of("x", "y"), List.of(x, y));
  }

  private static Optional<SignalDivergence> of(Trace base, Trace now) {
    return SignalDivergence.of(base, now, name -> true, true, 4);
  }

  @Test
  void theFirstDivergentStepCounts() {
    Trace base = trace(0, new double[] {0, 1, 2, 3}, new double[] {5, 5, 5, 5});
    Trace now = trace(0, new double[] {0, 1, 2, 9}, new double[] {5, 5, 6, 9});
    assertThat(of(base, now)).contains(new SignalDivergence("y", 0.02, 5, 6, false));
    assertThat(of(base, base)).isEmpty();
  }

  @Test
  void samplesAreMatchedByTheirTime() {
    Trace base = trace(-STEP, new double[] {7, 0, 1, 2}, new double[4]);
    Trace now = trace(0, new double[] {0, 1, 4}, new double[3]);
    assertThat(of(base, now)).contains(new SignalDivergence("x", 0.02, 2, 4, false));
  }

  @Test
  void lastBitsGiveWayToALaterDifference() {
    double close = Math.nextUp(1000.0) - 1000.0;
    Trace base = trace(0, new double[] {1000, 0, 0}, new double[3]);
    Trace bits = trace(0, new double[] {1000, close, 0}, new double[3]);
    assertThat(of(base, bits)).contains(new SignalDivergence("x", 0.01, 0, close, true));
    Trace both = trace(0, new double[] {1000, close, 1}, new double[3]);
    assertThat(of(base, both)).contains(new SignalDivergence("x", 0.02, 0, 1, false));
  }

  @Test
  void aTraceThatEndsEarlierDiverges() {
    Trace base = trace(0, new double[] {0, 1}, new double[2]);
    Trace now = trace(0, new double[] {0, 1, 2}, new double[3]);
    assertThat(of(base, now)).contains(new SignalDivergence("t", 0.01, 0.01, 0.02, false));
    assertThat(SignalDivergence.of(base, now, name -> true, false, 4)).isEmpty();
  }

  @Test
  void onlySelectedAndCommonSignalsCount() {
    Trace base = trace(0, new double[] {0}, new double[] {0});
    Trace now = trace(0, new double[] {1}, new double[] {1});
    assertThat(SignalDivergence.of(base, now, "y"::equals, true, 4))
        .hasValueSatisfying(found -> assertThat(found.signal()).isEqualTo("y"));
    Trace other = new Trace(0, STEP, List.of("z"), List.of(new double[] {3}));
    assertThat(of(base, other)).isEmpty();
  }
}
