package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.activity.ros.MessageSignals;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

/**
 * Adds the messages of a ROS 2 node to the signals of a case: each number of an output holds its
 * value until the next message, and is 0 before the first. An element that the last message does
 * not have is NaN.
 */
public final class MessageTraces {
  /** Times of messages have rounding errors. */
  private static final double EPSILON_S = 1e-9;

  private static final Pattern ELEMENT = Pattern.compile("(.+)\\[(\\d{1,6})]");

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
    Set<String> lists = MessageSignals.lists(messages).keySet();
    for (String name : wanted) {
      Matcher element = ELEMENT.matcher(name);
      if (element.matches() && lists.contains(element.group(1))) {
        names.add(name);
      }
    }
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
    Matcher element = ELEMENT.matcher(name);
    boolean isElement = element.matches();
    String member = isElement ? element.group(1) : name;
    int index = isElement ? Integer.parseInt(element.group(2)) : -1;
    String[] path = member.substring(dot + 1).split("\\.", -1);
    boolean isCount = name.endsWith(MessageSignals.COUNT) && path.length == 1;
    double[] column = new double[trace.count()];
    double value = 0;
    int next = 0;
    for (int k = 0; k < column.length; k++) {
      while (next < made.size() && time(made.get(next)) <= trace.seconds(k) + EPSILON_S) {
        value = isCount ? next + 1 : number(made.get(next), path, index);
        next++;
      }
      column[k] = value;
    }
    return column;
  }

  private static double time(Object message) {
    return number(message, new String[] {"t"}, -1);
  }

  /**
   * A number in a message; NaN if it has none there.
   *
   * @param index of an element of the array at the path; -1 if it is no array
   */
  private static double number(Object message, String[] path, int index) {
    Object found = message;
    for (String member : path) {
      found = found instanceof Map<?, ?> map ? map.get(member) : null;
    }
    if (index >= 0) {
      found = found instanceof List<?> list && index < list.size() ? list.get(index) : null;
    }
    if (found instanceof Boolean truth) {
      return truth ? 1 : 0;
    }
    return found instanceof Number number ? number.doubleValue() : Double.NaN;
  }
}
