package org.sitaf.runtime.component;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.PortChange;

/**
 * The values of output data ports of the component during a case, which trajectory conditions use.
 * Ports are read whenever simulation time is about to pass, which are all times at which they may
 * have changed.
 */
public final class WatchedPorts {
  /** Changes of all ports in a case that are recorded; a record has at most 1 MiB. */
  public static final int MOST_CHANGES = 20_000;

  private static final class Port {
    private final String signal;
    private final Callable<String> read;
    private final List<PortChange> changes = new ArrayList<>();
    private long leftOut;

    Port(String signal, Callable<String> read) {
      this.signal = signal;
      this.read = read;
    }
  }

  private final List<Port> ports = new ArrayList<>();
  private int count;
  private boolean reading;
  private @Nullable Exception failure;

  /**
   * Watches a port, or a part of it, until the end of the case.
   *
   * @throws Exception what {@code read} throws
   */
  public void watch(String signal, Callable<String> read, long nowNanos) throws Exception {
    Port port = new Port(signal, read);
    read(port, nowNanos);
    ports.add(port);
  }

  /**
   * Reads all ports. What a port throws is thrown by {@link #requireRead}, because the component
   * may be running.
   */
  public void take(long nowNanos) {
    // A port may itself let time pass.
    if (reading || failure != null) {
      return;
    }
    reading = true;
    try {
      for (Port port : ports) {
        read(port, nowNanos);
      }
    } catch (Exception e) {
      failure = e;
    } finally {
      reading = false;
    }
  }

  /**
   * Throws what a port threw.
   *
   * @throws Exception that one
   */
  public void requireRead() throws Exception {
    Exception thrown = failure;
    failure = null;
    if (thrown != null) {
      throw thrown;
    }
  }

  /** Receives the values of a port. */
  interface Receiver {
    void port(String signal, List<PortChange> changes, long leftOut);
  }

  /** Adds the values to a record, with times since the call. */
  public void writeTo(CaseResult result, long callNanos) {
    forEach(callNanos, result::addPort);
  }

  void forEach(long callNanos, Receiver receiver) {
    for (Port port : ports) {
      receiver.port(
          port.signal,
          port.changes.stream()
              .map(c -> new PortChange(c.nanos() - callNanos, c.literal()))
              .toList(),
          port.leftOut);
    }
  }

  /** Stops watching. */
  public void clear() {
    ports.clear();
    count = 0;
    failure = null;
  }

  private void read(Port port, long nowNanos) throws Exception {
    String literal = port.read.call();
    List<PortChange> changes = port.changes;
    PortChange last = changes.isEmpty() ? null : changes.get(changes.size() - 1);
    if (last != null && last.literal().equals(literal)) {
      return;
    }
    PortChange change = new PortChange(nowNanos, literal);
    if (last != null && last.nanos() == nowNanos) {
      changes.set(changes.size() - 1, change);
    } else if (count < MOST_CHANGES) {
      count++;
      changes.add(change);
    } else {
      port.leftOut++;
    }
  }
}
