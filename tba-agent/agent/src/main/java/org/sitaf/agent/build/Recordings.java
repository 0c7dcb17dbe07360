package org.sitaf.agent.build;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Takes what a test application recorded out of a folder that the component could write to, case by
 * case while they run, from a thread of its own. What is not wanted is deleted, so that the
 * application has room for more. A file counts when it is whole: binary glTF says how long it is.
 *
 * <p>It is looked at only after it was moved to a folder that the component does not reach, so that
 * nothing else can come in its place while it is opened.
 */
final class Recordings implements AutoCloseable {
  /** Of one file. */
  static final int MOST_BYTES = 32 << 20;

  private static final int HEADER_BYTES = 12;
  private static final int MAGIC = 0x46546C67;
  private static final long PAUSE_MS = 200;

  private final Path from;
  private final Path taken;
  private final RecordingOrder order;
  private final BuildListener listener;
  private final OutputSink log;
  private final Thread thread = new Thread(this::work, "sitaf-recordings");

  /** Cases that have ended, and whose recording was not there yet. */
  private final List<Ended> ended = new ArrayList<>();

  private boolean closed;

  // What follows belongs to whoever sweeps: the thread, and who closes after its end.
  /** Cases whose recording was moved, and was not whole yet. */
  private final Set<Integer> halves = new HashSet<>();

  private int kept;
  private long bytes;
  private int leftOut;
  private @Nullable IOException problem;

  private record Ended(int no, Verdict verdict) {}

  /**
   * Begins to take.
   *
   * @param from what the test application fills; need not be there yet
   */
  Recordings(Path from, RecordingOrder order, BuildListener listener, OutputSink log) {
    this.from = from;
    this.taken = from.resolveSibling(from.getFileName() + ".taken");
    this.order = order;
    this.listener = listener;
    this.log = log;
    thread.setDaemon(true);
    thread.start();
  }

  /** The recording of this case may be there soon, or never. */
  synchronized void expect(CaseResult result) {
    ended.add(new Ended(result.no(), result.verdict()));
  }

  private void work() {
    try {
      while (awaitNext()) {
        sweep();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private synchronized boolean awaitNext() throws InterruptedException {
    if (!closed) {
      wait(PAUSE_MS);
    }
    return !closed;
  }

  private void sweep() {
    List<Ended> some;
    synchronized (this) {
      some = List.copyOf(ended);
    }
    List<Ended> done = new ArrayList<>();
    for (Ended one : some) {
      try {
        if (take(one)) {
          done.add(one);
        }
      } catch (IOException e) {
        problem = e;
        done.add(one);
      }
    }
    synchronized (this) {
      ended.removeAll(done);
    }
  }

  /** False when there is no whole recording of the case yet. */
  private boolean take(Ended one) throws IOException {
    Path file = taken.resolve(one.no() + ".glb");
    if (move(one.no() + ".glb", file)) {
      halves.add(one.no());
    } else if (!halves.contains(one.no())) {
      return false;
    }
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(file.getFileName() + " is no regular file");
    }
    Optional<byte[]> gltf = wholeGlb(file);
    if (gltf.isEmpty()) {
      return false;
    }
    Files.delete(file);
    halves.remove(one.no());
    if (!order.cases().include(one.verdict())) {
      return true;
    }
    byte[] content = gltf.get();
    if (kept >= order.maxRecordings() || bytes + content.length > order.maxBytes()) {
      leftOut++;
      return true;
    }
    kept++;
    bytes += content.length;
    Files.createDirectories(order.folder());
    Path target = order.folder().resolve(one.no() + ".glb");
    Files.write(target, content);
    listener.recorded(one.no(), target);
    return true;
  }

  /** False when it is not there yet. Who writes it writes on, wherever it lies. */
  private boolean move(String name, Path to) throws IOException {
    Path file = from.resolve(name);
    if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    Files.createDirectories(taken);
    try {
      Files.move(file, to, StandardCopyOption.ATOMIC_MOVE);
      return true;
    } catch (NoSuchFileException e) {
      return false;
    }
  }

  private static Optional<byte[]> wholeGlb(Path file) throws IOException {
    try (InputStream in =
        Files.newInputStream(file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
      byte[] content = in.readNBytes(MOST_BYTES + 1);
      ByteBuffer header = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
      boolean whole =
          content.length >= HEADER_BYTES
              && content.length <= MOST_BYTES
              && header.getInt() == MAGIC
              && header.getInt(2 * Integer.BYTES) == content.length;
      return whole ? Optional.of(content) : Optional.empty();
    }
  }

  /** Takes what is left once the test application has ended, and says how much there is. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
      return;
    }
    sweep();
    report();
  }

  private void report() {
    if (kept > 0 || leftOut > 0) {
      log.remark(
          "recordings: %d cases, %.1f MiB".formatted(kept, bytes / (double) (1 << 20))
              + (leftOut == 0
                  ? ""
                  : "; %d more are left out: a build keeps %d of at most %d MiB"
                      .formatted(leftOut, order.maxRecordings(), order.maxBytes() >> 20)));
    }
    if (problem != null) {
      log.remark("some recordings are lost: " + problem);
    }
  }
}
