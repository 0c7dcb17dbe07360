package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.core.activity.ros.MessageSignals;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

/**
 * Adds the messages of a ROS 2 node to the signals of a case: each number of an output holds its
 * value until the next message, and is 0 before the first.
 */
public final class MessageTraces {
  /** Times of messages have rounding errors. */
  private static final double EPSILON_S = 1e-9;

  private final CallRecord calls;
  private final Set<String> names;

  /**
   * Traces of some signals.
   *
   * @param messages the interface whose calls are the messages
   * @param wanted names of signals; those that are no messages are ignored
   */
  public MessageTraces(InterfaceDescription messages, Collection<String> wanted) {
    this.calls = new CallRecord(List.of(messages));
    this.names = new TreeSet<>(MessageSignals.of(messages));
    this.names.retainAll(wanted);
  }

  /** The signals that are added. */
  public Set<String> names() {
    return Set.copyOf(names);
  }

  /**
   * The signals of a case with those of its messages.
   *
   * @param recorded the calls of the case
   * @throws MissingTraceException if some messages were not recorded
   */
  public Trace extended(Trace trace, StubCalls recorded) throws MissingTraceException {
    if (names.isEmpty()) {
      return trace;
    }
    if (recorded.leftOut() > 0) {
      throw new MissingTraceException(
          "the case has "
              + recorded.leftOut()
              + " messages or calls more than are recorded, so the signals of messages are not"
              + " complete");
    }
    Map<String, Object> messages = calls.messages(recorded);
    List<String> all = new ArrayList<>(trace.names());
    List<double[]> columns = new ArrayList<>(trace.columns());
    for (String name : names) {
      all.add(name);
      columns.add(column(name, messages, trace));
    }
    return new Trace(trace.firstNanos(), trace.stepNanos(), all, columns);
  }

  private static double[] column(String name, Map<String, Object> messages, Trace trace) {
    int dot = name.indexOf('.');
    List<?> made = messages.get(name.substring(0, dot)) instanceof List<?> list ? list : List.of();
    String[] path = name.substring(dot + 1).split("\\.", -1);
    boolean isCount = name.endsWith(MessageSignals.COUNT) && path.length == 1;
    double[] column = new double[trace.count()];
    double value = 0;
    int next = 0;
    for (int k = 0; k < column.length; k++) {
      while (next < made.size() && time(made.get(next)) <= trace.seconds(k) + EPSILON_S) {
        value = isCount ? next + 1 : number(made.get(next), path);
        next++;
      }
      column[k] = value;
    }
    return column;
  }

  private static double time(Object message) {
    return number(message, new String[] {"t"});
  }

  /** A number in a message; NaN if it has none there. */
  private static double number(Object message, String[] path) {
    Object found = message;
    for (String member : path) {
      found = found instanceof Map<?, ?> map ? map.get(member) : null;
    }
    if (found instanceof Boolean truth) {
      return truth ? 1 : 0;
    }
    return found instanceof Number number ? number.doubleValue() : Double.NaN;
  }
}
