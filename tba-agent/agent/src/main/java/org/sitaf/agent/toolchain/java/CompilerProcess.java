package org.sitaf.agent.toolchain.java;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.sitaf.agent.sandbox.ConfinedProcess;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.java.confined.Wire;

/**
 * The Java compiler in the sandbox, for one compilation. Its answer is not trusted, because its
 * input may have exploited it.
 */
final class CompilerProcess implements AutoCloseable {
  /** Memory in addition to the heap: classes, code, stacks and mapped jars. */
  private static final int OVERHEAD_MIB = 512;

  private static final ProcessLimits LIMITS =
      new ProcessLimits(CompilerSetup.MEMORY_MIB + OVERHEAD_MIB, 256, 1024, Duration.ofMinutes(10));
  private static final long MAX_ANSWER_BYTES = 512L << 20;
  private static final Duration EXIT_TIMEOUT = Duration.ofSeconds(5);

  /** Exit code of a shell for SIGKILL. */
  private static final int KILLED = 137;

  private final Sandbox sandbox;
  private final Path folder;
  private final ConfinedProcess process;
  private final ErrorLine errorLine;

  private CompilerProcess(Sandbox sandbox, Path folder, ConfinedProcess process) {
    this.sandbox = sandbox;
    this.folder = folder;
    this.process = process;
    this.errorLine = new ErrorLine(process.errors());
  }

  /**
   * Starts a compiler that waits for its request.
   *
   * @param folder a folder that does not exist yet, for its files
   */
  static CompilerProcess start(CompilerSetup setup, Sandbox sandbox, Path folder)
      throws IOException {
    Files.createDirectories(folder);
    try {
      Confinement confinement =
          Confinement.of(setup.command(folder), folder, folder, LIMITS)
              .reading(setup.readable())
              .withInputOpen();
      return new CompilerProcess(sandbox, folder, sandbox.start(confinement));
    } catch (IOException e) {
      delete(folder);
      throw e;
    }
  }

  /** Lets it use only processor time that nobody else needs, or an equal share again. */
  void setIdle(boolean idle) {
    process.setIdle(idle);
  }

  /** Whether it can take a request in this sandbox. */
  boolean isReadyIn(Sandbox wanted) throws InterruptedException {
    // Another agent with the same cache may have removed the folder as stale.
    return sandbox.equals(wanted) && Files.isDirectory(folder) && !process.awaitEnd(Duration.ZERO);
  }

  /** Writes the request. */
  interface Request {
    void write(OutputStream compiler) throws IOException;
  }

  /** Reads the answer. */
  interface Answer {
    /** Reads all messages up to the last one. */
    void read(Wire.Reader messages) throws IOException, CompilationException;
  }

  /** Sends the request and reads the answer; call it once. Closing the process ends it. */
  void exchange(Request request, Answer answer)
      throws IOException, CompilationException, InterruptedException {
    boolean ready = false;
    try (OutputStream input = new BufferedOutputStream(process.input(), 1 << 16)) {
      Wire.Reader messages =
          new Wire.Reader(new BufferedInputStream(process.output(), 1 << 16), MAX_ANSWER_BYTES);
      // Sent before the process is ready, so that it stops warming up.
      request.write(input);
      input.flush();
      if (!messages.next().word().equals(Wire.READY)) {
        throw new IOException("unexpected first message");
      }
      ready = true;
      answer.read(messages);
    } catch (CompilerAnswer.OutputException e) {
      throw e;
    } catch (IOException e) {
      throw explain(ready, e);
    }
  }

  /** Explains why the exchange failed. */
  private IOException explain(boolean ready, IOException failure)
      throws CompilationException, InterruptedException {
    boolean ended =
        process.awaitEnd(failure instanceof Wire.ProtocolException ? Duration.ZERO : EXIT_TIMEOUT);
    if (!ready) {
      return new IOException(
          "the Java compiler does not start: "
              + (errorLine.text().isEmpty() ? failure.getMessage() : errorLine.text()),
          failure);
    }
    if (process.exceededLimit().isPresent()
        || (ended && process.exitCode() == Wire.OUT_OF_MEMORY)) {
      throw new CompilationException(
          "the compiler used more than "
              + CompilerSetup.MEMORY_MIB
              + " MiB of memory; simplify the sources, for example move large constants to a file",
          List.of());
    }
    if (ended && process.exitCode() == KILLED) {
      return new IOException("the Java compiler was killed", failure);
    }
    throw new CompilationException(
        "the compiler failed ("
            + (ended ? "exit code " + process.exitCode() : failure.getMessage())
            + (errorLine.text().isEmpty() ? "" : ": " + errorLine.text())
            + "); simplify the sources",
        List.of());
  }

  @Override
  public void close() {
    process.close();
    delete(folder);
  }

  private static void delete(Path folder) {
    try {
      Folders.delete(folder);
    } catch (IOException e) {
      // The next start of an agent deletes it.
    }
  }

  /** Keeps the first line of the error stream and discards the rest. */
  private static final class ErrorLine {
    private static final int MAX_LENGTH = 300;
    private final StringBuilder text = new StringBuilder();

    ErrorLine(InputStream errors) {
      Thread reader = new Thread(() -> read(errors), "sitaf-javac-errors");
      reader.setDaemon(true);
      reader.start();
    }

    private void read(InputStream errors) {
      byte[] buffer = new byte[4096];
      try (errors) {
        for (int n = errors.read(buffer); n >= 0; n = errors.read(buffer)) {
          synchronized (text) {
            if (text.length() < MAX_LENGTH) {
              text.append(new String(buffer, 0, n, StandardCharsets.UTF_8));
            }
          }
        }
      } catch (IOException e) {
        // The process has ended.
      }
    }

    String text() {
      synchronized (text) {
        String first = text.toString().lines().findFirst().orElse("").strip();
        return first.substring(0, Math.min(MAX_LENGTH, first.length()));
      }
    }
  }
}
