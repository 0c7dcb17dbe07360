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
 * Java's compiler in the sandbox, for one compilation. Its answer is taken as a stranger's, because
 * what it reads may have made it one.
 */
final class CompilerProcess implements AutoCloseable {
  /** Next to the heap: classes, code, stacks, and jars that are mapped. */
  private static final int OVERHEAD_MIB = 512;

  private static final ProcessLimits LIMITS =
      new ProcessLimits(CompilerSetup.MEMORY_MIB + OVERHEAD_MIB, 256, 1024, Duration.ofMinutes(10));
  private static final long LONGEST_ANSWER_BYTES = 512L << 20;
  private static final Duration END = Duration.ofSeconds(5);

  /** As shells add a signal's number. */
  private static final int KILLED = 137;

  private final Sandbox sandbox;
  private final Path folder;
  private final ConfinedProcess process;
  private final Complaint complaint;

  private CompilerProcess(Sandbox sandbox, Path folder, ConfinedProcess process) {
    this.sandbox = sandbox;
    this.folder = folder;
    this.process = process;
    this.complaint = new Complaint(process.errors());
  }

  /**
   * Starts a compiler, which waits for its request.
   *
   * @param folder a folder that does not exist, for its files
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

  /** Whether it can take a request, in this sandbox. */
  boolean isReadyIn(Sandbox wanted) throws InterruptedException {
    // Another agent of this cache may have taken the folder for one that was left behind.
    return sandbox.equals(wanted) && Files.isDirectory(folder) && !process.awaitEnd(Duration.ZERO);
  }

  /** What a compilation is asked for. */
  interface Request {
    void write(OutputStream compiler) throws IOException;
  }

  /** What becomes of the messages of the answer. */
  interface Answer {
    /** Takes the messages up to the last. */
    void read(Wire.Reader messages) throws IOException, CompilationException;
  }

  /**
   * Sends the request and reads the answer, once. Ends when the process is closed, at the latest.
   */
  void exchange(Request request, Answer answer)
      throws IOException, CompilationException, InterruptedException {
    boolean ready = false;
    try (OutputStream input = new BufferedOutputStream(process.input(), 1 << 16)) {
      Wire.Reader messages =
          new Wire.Reader(new BufferedInputStream(process.output(), 1 << 16), LONGEST_ANSWER_BYTES);
      // Before it is ready, so that it gets no warmer than it has time for.
      request.write(input);
      input.flush();
      if (!messages.next().word().equals(Wire.READY)) {
        throw new IOException("it says something else than that it is ready");
      }
      ready = true;
      answer.read(messages);
    } catch (CompilerAnswer.OutputException e) {
      throw e;
    } catch (IOException e) {
      throw explained(ready, e);
    }
  }

  /** What it means that the exchange broke off. */
  private IOException explained(boolean ready, IOException failure)
      throws CompilationException, InterruptedException {
    boolean ended =
        process.awaitEnd(failure instanceof Wire.ProtocolException ? Duration.ZERO : END);
    if (!ready) {
      return new IOException(
          "the Java compiler does not start: "
              + (complaint.text().isEmpty() ? failure.getMessage() : complaint.text()),
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
        "the compiler gave up ("
            + (ended ? "exit code " + process.exitCode() : failure.getMessage())
            + (complaint.text().isEmpty() ? "" : ": " + complaint.text())
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
      // The next start of an agent tries again.
    }
  }

  /** The first line that the process writes to its error stream; the rest is read and dropped. */
  private static final class Complaint {
    private static final int LONGEST = 300;
    private final StringBuilder text = new StringBuilder();

    Complaint(InputStream errors) {
      Thread reader = new Thread(() -> read(errors), "sitaf-javac-errors");
      reader.setDaemon(true);
      reader.start();
    }

    private void read(InputStream errors) {
      byte[] buffer = new byte[4096];
      try (errors) {
        for (int n = errors.read(buffer); n >= 0; n = errors.read(buffer)) {
          synchronized (text) {
            if (text.length() < LONGEST) {
              text.append(new String(buffer, 0, n, StandardCharsets.UTF_8));
            }
          }
        }
      } catch (IOException e) {
        // The process is gone.
      }
    }

    String text() {
      synchronized (text) {
        String first = text.toString().lines().findFirst().orElse("").strip();
        return first.substring(0, Math.min(LONGEST, first.length()));
      }
    }
  }
}
