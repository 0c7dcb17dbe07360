package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.ros.MessageSignals;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

class MessageTracesTest {
  private static final DataType NUMBER = new DataType.Scalar(ScalarType.DOUBLE);
  private static final InterfaceDescription MESSAGES =
      new InterfaceDescription(
          "topics",
          List.of(
              new Method(
                  "command",
                  new DataType.Scalar(ScalarType.VOID),
                  List.of(
                      in(
                          "linear",
                          new DataType.Struct(
                              "Vector3", List.of(new DataType.Member("x", NUMBER)))),
                      in("ranges", new DataType.Sequence(NUMBER, 0)),
                      in("on", new DataType.Scalar(ScalarType.BOOLEAN)),
                      in("t", NUMBER)),
                  CallType.BLOCKING,
                  List.of(),
                  0)),
          "activity.yaml",
          Map.of());
  private static final Trace TRACE =
      new Trace(-10_000_000, 10_000_000, List.of("robot_x"), List.of(new double[6]));

  private static Parameter in(String name, DataType type) {
    return new Parameter(name, type, Direction.IN);
  }

  private static StubCalls.Call message(String x, String on, String t) {
    return new StubCalls.Call(
        "topics.command",
        List.of(
            new NamedValue("linear", "{x: " + x + "}"),
            new NamedValue("ranges", "[1.0]"),
            new NamedValue("on", on),
            new NamedValue("t", t)));
  }

  @Test
  void signalsAreNumbersAndElementsOfArrays() {
    assertThat(MessageSignals.of(MESSAGES))
        .containsExactly("command.linear.x", "command.on", "command.count");
    assertThat(MessageSignals.lists(MESSAGES))
        .containsExactly(Map.entry("command.ranges", TrajectoryConditions.ANY_LENGTH));
  }

  @Test
  void anElementThatTheLastMessageDoesNotHaveIsNotANumber() throws Exception {
    StubCalls calls =
        new StubCalls(List.of(message("0.5", "true", "0.01"), message("1.0", "true", "0.03")), 0);

    MessageTraces traces =
        new MessageTraces(
            MESSAGES, List.of("command.ranges[0]", "command.ranges[1]", "command.other[0]"));
    assertThat(traces.names()).containsExactlyInAnyOrder("command.ranges[0]", "command.ranges[1]");
    Trace extended = traces.extended(TRACE, calls);

    assertThat(extended.columns().get(1)).containsExactly(0, 0, 1, 1, 1, 1);
    assertThat(extended.columns().get(2))
        .containsExactly(0, 0, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
  }

  @Test
  void aSignalHoldsTheValueOfTheLastMessage() throws Exception {
    StubCalls calls =
        new StubCalls(List.of(message("0.5", "true", "0.01"), message("-1.0", "false", "0.03")), 0);

    Trace extended =
        new MessageTraces(MESSAGES, MessageSignals.of(MESSAGES)).extended(TRACE, calls);

    // The samples are at -0.01, 0, 0.01, 0.02, 0.03 and 0.04 s.
    assertThat(extended.names())
        .containsExactly("robot_x", "command.count", "command.linear.x", "command.on");
    assertThat(extended.columns().get(1)).containsExactly(0, 0, 1, 1, 2, 2);
    assertThat(extended.columns().get(2)).containsExactly(0, 0, 0.5, 0.5, -1, -1);
    assertThat(extended.columns().get(3)).containsExactly(0, 0, 1, 1, 0, 0);
  }

  @Test
  void messagesThatAreNotRecordedMakeSignalsIncomplete() throws Exception {
    StubCalls calls = new StubCalls(List.of(message("0.5", "true", "0.01")), 7);
    MessageTraces used = new MessageTraces(MESSAGES, List.of("command.count"));

    assertThatThrownBy(() -> used.extended(TRACE, calls))
        .isInstanceOf(MissingTraceException.class)
        .hasMessageContaining("7 messages or calls more");
    assertThat(new MessageTraces(MESSAGES, List.of("robot_x")).extended(TRACE, calls))
        .isSameAs(TRACE);
  }
}
