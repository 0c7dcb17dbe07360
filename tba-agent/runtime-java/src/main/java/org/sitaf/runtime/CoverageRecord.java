package org.sitaf.runtime;

import java.lang.reflect.Method;

/**
 * Saves the coverage of the component periodically. The JaCoCo agent itself saves it only when the
 * JVM shuts down normally, which a component can prevent.
 */
final class CoverageRecord implements Runnable {
  /** Set by the process that started this JVM with the JaCoCo agent. */
  private static final String WANTED = "sitaf.coverage";

  private static final long FIRST_PAUSE_MS = 50;
  private static final long MAX_PAUSE_MS = 2000;

  private final Object recorder;
  private final Method dump;

  private CoverageRecord(Object recorder, Method dump) {
    this.recorder = recorder;
    this.dump = dump;
  }

  /** Starts the periodic saving if this JVM records coverage. */
  static void begin() {
    if (!Boolean.getBoolean(WANTED)) {
      return;
    }
    try {
      Class<?> entry = Class.forName("org.jacoco.agent.rt.RT");
      Object recorder = entry.getMethod("getAgent").invoke(null);
      Method dump = Class.forName("org.jacoco.agent.rt.IAgent").getMethod("dump", boolean.class);
      Thread thread = new Thread(new CoverageRecord(recorder, dump), "sitaf-coverage");
      thread.setDaemon(true);
      thread.start();
    } catch (ReflectiveOperationException e) {
      System.err.println("sitaf: coverage is saved only at the end: " + e);
    }
  }

  @Override
  public void run() {
    try {
      for (long pause = FIRST_PAUSE_MS; ; pause = Math.min(2 * pause, MAX_PAUSE_MS)) {
        Thread.sleep(pause);
        dump.invoke(recorder, false);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ReflectiveOperationException e) {
      System.err.println("sitaf: coverage cannot be saved: " + e.getCause());
    }
  }
}
