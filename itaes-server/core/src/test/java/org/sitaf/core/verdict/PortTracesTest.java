package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.PortSignals;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.PortChanges.Change;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

class PortTracesTest {
  private static final DataType NUMBER = new DataType.Scalar(ScalarType.DOUBLE);
  private static final List<Port.Data> PORTS =
      List.of(
          new Port.Data("speed", NUMBER, true),
          new Port.Data(
              "state",
              new DataType.Struct(
                  "State",
                  List.of(
                      new DataType.Member("on", new DataType.Scalar(ScalarType.BOOLEAN)),
                      new DataType.Member("text", new DataType.Scalar(ScalarType.STRING)),
                      new DataType.Member("gains", new DataType.FixedArray(NUMBER, 3)))),
              true),
          new Port.Data("phase", new DataType.Enumeration("Phase", List.of("IDLE", "RUN")), true),
          new Port.Data("path", new DataType.Sequence(NUMBER, 0), true));

  /** Samples at -10, 0, 10, 20 and 30 ms. */
  private static final Trace TRACE =
      new Trace(-10_000_000, 10_000_000, List.of("robot_x"), List.of(new double[5]));

  private static double[] column(String signal, Change... changes) throws MissingTraceException {
    Trace extended =
        new PortTraces(PORTS, List.of("robot_x", signal))
            .extended(TRACE, List.of(new PortChanges(signal, List.of(changes), 0)));
    assertThat(extended.names()).containsExactly("robot_x", signal);
    return extended.columns().get(1);
  }

  @Test
  void signalsAreNumbersBooleansAndEnumerations() {
    assertThat(PortSignals.of(PORTS)).containsExactly("speed", "state.on", "phase");
    assertThat(PortSignals.lists(PORTS)).containsOnlyKeys("state.gains").containsValue(3);
    assertThat(PortSignals.type(PORTS, "state.gains[2]")).contains(NUMBER);
    assertThat(PortSignals.type(PORTS, "state.gains[3]")).isEmpty();
    assertThat(PortSignals.type(PORTS, "state.text")).isEmpty();
    assertThat(PortSignals.type(PORTS, "path")).isEmpty();
    assertThat(PortSignals.type(PORTS, "robot_x")).isEmpty();
  }

  @Test
  void aPortHoldsItsLastValueAndIsZeroBeforeTheFirst() throws MissingTraceException {
    assertThat(column("speed", new Change(0, "1.5"), new Change(15_000_000, "-2.0")))
        .containsExactly(0, 1.5, 1.5, -2, -2);
    assertThat(column("speed", new Change(-10_000_000, "null"), new Change(30_000_000, "NaN")))
        .containsExactly(0, 0, 0, 0, Double.NaN);
    assertThat(column("state.gains[2]", new Change(40_000_000, "7")))
        .containsExactly(0, 0, 0, 0, 0);
  }

  @Test
  void severalChangesBetweenTwoSamplesShowTheLast() throws MissingTraceException {
    assertThat(column("speed", new Change(1, "1.0"), new Change(2, "2.0")))
        .containsExactly(0, 0, 2, 2, 2);
  }

  @Test
  void booleansAndEnumerationsAreNumbers() throws MissingTraceException {
    assertThat(column("state.on", new Change(-10_000_000, "true"), new Change(10_000_000, "false")))
        .containsExactly(1, 1, 0, 0, 0);
    assertThat(column("phase", new Change(0, "RUN"), new Change(20_000_000, "IDLE")))
        .containsExactly(0, 1, 1, 0, 0);
  }

  @Test
  void incompleteAndImpossibleValuesAreNotJudged() {
    PortTraces traces = new PortTraces(PORTS, List.of("phase"));
    assertThatThrownBy(
            () -> traces.extended(TRACE, List.of(new PortChanges("phase", List.of(), 7))))
        .isInstanceOf(MissingTraceException.class)
        .hasMessageContaining("the data port phase changed 7 times more than is recorded");
    assertThatThrownBy(() -> traces.extended(TRACE, List.of()))
        .isInstanceOf(MissingTraceException.class)
        .hasMessageContaining("recorded no values of the data port phase");
    assertThatThrownBy(() -> column("phase", new Change(0, "FLY")))
        .isInstanceOf(MissingTraceException.class)
        .hasMessageContaining("is 'FLY', which is no Phase");
    assertThatThrownBy(() -> column("speed", new Change(0, "[1.0]")))
        .isInstanceOf(MissingTraceException.class)
        .hasMessageContaining("the data port speed is '[1.0]'");
  }

  @Test
  void aTraceWithoutPortsStaysAsItIs() throws MissingTraceException {
    assertThat(new PortTraces(PORTS, List.of("robot_x")).extended(TRACE, List.of()))
        .isSameAs(TRACE);
  }
}
