package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sitaf.core.activity.PortSignals;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.PortChanges.Change;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

/**
 * Adds output data ports of the component to the signals of a case. A port holds its last value,
 * and is 0 before the first; a boolean is 0 or 1, an enumeration the position of its literal.
 */
public final class PortTraces {
  private final Map<String, DataType> types = new TreeMap<>();

  /**
   * Traces of some signals.
   *
   * @param ports output data ports of the component
   * @param used names of signals; those that are no ports are ignored
   */
  public PortTraces(Collection<Port.Data> ports, Collection<String> used) {
    for (String name : used) {
      PortSignals.type(ports, name).ifPresent(type -> types.put(name, type));
    }
  }

  /** The signals that are added. */
  public Collection<String> names() {
    return List.copyOf(types.keySet());
  }

  /**
   * The signals of a case with those of the ports.
   *
   * @param recorded what the test application recorded
   * @throws MissingTraceException if some changes were not recorded, or are not values of the port
   */
  public Trace extended(Trace trace, List<PortChanges> recorded) throws MissingTraceException {
    if (types.isEmpty()) {
      return trace;
    }
    List<String> names = new ArrayList<>(trace.names());
    List<double[]> columns = new ArrayList<>(trace.columns());
    for (Map.Entry<String, DataType> signal : types.entrySet()) {
      Optional<PortChanges> changes =
          recorded.stream().filter(c -> c.signal().equals(signal.getKey())).findFirst();
      if (changes.isEmpty()) {
        throw new MissingTraceException(
            "the test application recorded no values of the data port " + signal.getKey());
      }
      names.add(signal.getKey());
      columns.add(column(changes.get(), signal.getValue(), trace));
    }
    return new Trace(trace.firstNanos(), trace.stepNanos(), names, columns);
  }

  private static double[] column(PortChanges recorded, DataType type, Trace trace)
      throws MissingTraceException {
    if (recorded.leftOut() > 0) {
      throw new MissingTraceException(
          "the data port "
              + recorded.signal()
              + " changed "
              + recorded.leftOut()
              + " times more than is recorded, so its signal is not complete; shorten the case, or"
              + " use fewer data ports in trajectory conditions");
    }
    double[] column = new double[trace.count()];
    double value = 0;
    int next = 0;
    List<Change> changes = recorded.changes();
    for (int k = 0; k < column.length; k++) {
      while (next < changes.size() && changes.get(next).nanos() <= trace.nanos(k)) {
        value = number(recorded.signal(), changes.get(next).literal(), type);
        next++;
      }
      column[k] = value;
    }
    return column;
  }

  private static double number(String signal, String literal, DataType type)
      throws MissingTraceException {
    if (literal.equals(Literals.NULL)) {
      return 0;
    }
    if (type instanceof DataType.Enumeration enumeration) {
      int at = enumeration.literals().indexOf(literal);
      if (at >= 0) {
        return at;
      }
    } else if (Literals.isBoolean(literal)) {
      return literal.equals("true") ? 1 : 0;
    } else if (Literals.isReal(literal)) {
      return Literals.real(literal);
    }
    throw new MissingTraceException(
        "the value of the data port "
            + signal
            + " is '"
            + literal.substring(0, Math.min(literal.length(), 200))
            + "', which is no "
            + type.typeName());
  }
}
