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
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Collects the recordings of a test application while it runs, in a background thread. The
 * component can write to the folder, too. Unwanted recordings are deleted to make room for more. A
 * file is complete if it has the length in its binary glTF header.
 *
 * <p>A file is moved to a folder that the component cannot reach before it is opened, so that the
 * component cannot replace it.
 */
final class Recordings implements AutoCloseable {
  /** Size limit of a file. */
  static final int MAX_BYTES = 32 << 20;

  private static final int HEADER_BYTES = 12;
  private static final int MAGIC = 0x46546C67;
  private static final long PAUSE_MS = 200;

  private final Map<Integer, Path> from;
  private final Path collected;
  private final List<Path> secondRuns;
  private final RecordingOrder order;
  private final BuildListener listener;
  private final OutputSink log;
  private final Thread thread = new Thread(this::work, "sitaf-recordings");

  /** Finished cases whose recording has not appeared yet. */
  private final List<Ended> ended = new ArrayList<>();

  private boolean closed;

  // The following fields are used by the collecting thread, and by close() after its end.
  /** Cases whose recording was moved but is not complete yet. */
  private final Set<Integer> incomplete = new HashSet<>();

  private final KeptFiles kept;
  private @Nullable IOException problem;

  private record Ended(int no, Verdict verdict) {}

  /**
   * Starts to collect.
   *
   * @param from folder of the test application, by the number of the case; need not exist yet
   * @param collected folder for files that are moved out of those folders; the component cannot
   *     access it
   * @param secondRuns for each relation the folder of the recordings of its second runs, which have
   *     ended; the component cannot access it
   */
  Recordings(
      Map<Integer, Path> from,
      Path collected,
      List<Path> secondRuns,
      RecordingOrder order,
      BuildListener listener,
      OutputSink log) {
    this.from = Map.copyOf(from);
    this.collected = collected;
    this.secondRuns = List.copyOf(secondRuns);
    this.order = order;
    this.kept = new KeptFiles("recordings", order.maxRecordings(), order.maxBytes());
    this.listener = listener;
    this.log = log;
    thread.setDaemon(true);
    thread.start();
  }

  /** A case has finished; its recording may follow. */
  synchronized void expect(CaseResult result) {
    ended.add(new Ended(result.no(), result.verdict()));
  }

  private void work() {
    try {
      while (awaitNext()) {
        collect();
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

  private void collect() {
    List<Ended> some;
    synchronized (this) {
      some = List.copyOf(ended);
    }
    List<Ended> done = new ArrayList<>();
    for (Ended one : some) {
      try {
        if (collect(one)) {
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

  /** Returns false if the recording is missing or incomplete. */
  private boolean collect(Ended one) throws IOException {
    Path file = collected.resolve(one.no() + ".glb");
    if (move(one.no(), file)) {
      incomplete.add(one.no());
    } else if (!incomplete.contains(one.no())) {
      return false;
    }
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(file.getFileName() + " is not a regular file");
    }
    Optional<byte[]> gltf = wholeGlb(file);
    if (gltf.isEmpty()) {
      return false;
    }
    Files.delete(file);
    incomplete.remove(one.no());
    if (!order.cases().include(one.verdict())) {
      return true;
    }
    byte[] content = gltf.get();
    long size = content.length;
    Map<Integer, Path> others = secondRuns(one.no());
    for (Path other : others.values()) {
      size += Files.size(other);
    }
    if (!kept.admit(size)) {
      return true;
    }
    Files.createDirectories(order.folder());
    Path target = order.folder().resolve(new RecordingFile(one.no(), 0).name());
    Files.write(target, content);
    listener.recorded(one.no(), target);
    for (Map.Entry<Integer, Path> other : others.entrySet()) {
      Path second = order.folder().resolve(new RecordingFile(one.no(), other.getKey()).name());
      // The folders can be on different file systems.
      Files.move(other.getValue(), second, StandardCopyOption.REPLACE_EXISTING);
      listener.secondRunRecorded(one.no(), other.getKey(), second);
    }
    return true;
  }

  /** The recordings of the second runs of a case, by the index of the relation, from 1. */
  private Map<Integer, Path> secondRuns(int no) {
    Map<Integer, Path> found = new TreeMap<>();
    for (int i = 0; i < secondRuns.size(); i++) {
      Path file = secondRuns.get(i).resolve(new RecordingFile(no, 0).name());
      if (Files.exists(file)) {
        found.put(i + 1, file);
      }
    }
    return found;
  }

  /** Returns false if the file is missing. A process that has it open can still write to it. */
  private boolean move(int no, Path to) throws IOException {
    Path folder = from.get(no);
    if (folder == null) {
      return false;
    }
    Path file = folder.resolve(no + ".glb");
    if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    Files.createDirectories(collected);
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
      byte[] content = in.readNBytes(MAX_BYTES + 1);
      ByteBuffer header = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
      boolean whole =
          content.length >= HEADER_BYTES
              && content.length <= MAX_BYTES
              && header.getInt() == MAGIC
              && header.getInt(2 * Integer.BYTES) == content.length;
      return whole ? Optional.of(content) : Optional.empty();
    }
  }

  /** Collects the rest after the end of the test application, and logs the totals. */
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
    collect();
    report();
  }

  private void report() {
    kept.totals().ifPresent(log::remark);
    if (problem != null) {
      log.remark("some recordings are lost: " + problem);
    }
  }
}
