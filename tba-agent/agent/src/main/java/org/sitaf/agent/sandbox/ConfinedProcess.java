package org.sitaf.agent.sandbox;

import java.io.InputStream;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A process of other people's code at work, with all that it started. */
public final class ConfinedProcess implements AutoCloseable {
  private final Process process;
  private final ProcessGroup group;

  ConfinedProcess(Process process, ProcessGroup group) {
    this.process = process;
    this.group = group;
  }

  public InputStream output() {
    return process.getInputStream();
  }

  public InputStream errors() {
    return process.getErrorStream();
  }

  /** Waits for the end; true when it came within that time. */
  public boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.waitFor(atMost.toMillis(), TimeUnit.MILLISECONDS);
  }

  /** Ends it now, with all that it started. */
  public void kill() throws InterruptedException {
    destroy();
    process.waitFor();
  }

  /** Ends what it left behind, which would keep its output open. */
  public void killRest() {
    group.kill();
  }

  /** Its exit code; above 128 a signal's number is added, as shells have it. Only after its end. */
  public int exitCode() {
    return process.exitValue();
  }

  @Override
  public void close() {
    destroy();
  }

  private void destroy() {
    List<ProcessHandle> descendants = process.descendants().toList();
    process.destroyForcibly();
    descendants.forEach(ProcessHandle::destroyForcibly);
    group.kill();
  }
}
