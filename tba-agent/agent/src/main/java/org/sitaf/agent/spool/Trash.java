package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.UUID;

/**
 * Moves folders away with one rename and deletes them later in a background thread. The next agent
 * deletes what is left.
 */
public final class Trash implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration DELETE_TIMEOUT = Duration.ofMinutes(30);
  private static final Duration CLOSE_TIMEOUT = Duration.ofSeconds(3);

  private final Path folder;
  private final Set<Path> undeletable = new HashSet<>();
  private final Thread thread = new Thread(this::work, "sitaf-trash");
  private boolean pending = true;
  private boolean working;

  private Trash(Path folder) {
    this.folder = folder;
    thread.setDaemon(true);
  }

  /** Opens the folder and starts to delete its content. */
  static Trash open(Path folder) throws IOException {
    Files.createDirectories(folder);
    Trash trash = new Trash(folder);
    trash.thread.start();
    return trash;
  }

  /**
   * Moves a folder into the trash; its path is free when this returns.
   *
   * @param path on the same file system as the trash
   */
  public void add(Path path) throws IOException {
    Files.move(path, folder.resolve(UUID.randomUUID().toString()), StandardCopyOption.ATOMIC_MOVE);
    synchronized (this) {
      pending = true;
      notifyAll();
    }
  }

  private void work() {
    try {
      while (true) {
        synchronized (this) {
          working = false;
          notifyAll();
          while (!pending) {
            wait();
          }
          pending = false;
          working = true;
        }
        deleteAll();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        working = false;
        notifyAll();
      }
    }
  }

  private void deleteAll() throws InterruptedException {
    try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
      for (Path path : all) {
        if (!undeletable.contains(path)) {
          delete(path);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      LOGGER.log(System.Logger.Level.WARNING, folder + " cannot be read: " + e.getMessage());
    }
  }

  private void delete(Path path) throws InterruptedException {
    try {
      Folders.deleteByTool(path, DELETE_TIMEOUT);
    } catch (IOException e) {
      undeletable.add(path);
      LOGGER.log(
          System.Logger.Level.WARNING,
          path + " cannot be deleted: " + e.getMessage() + "; please delete it manually");
    }
  }

  /** Stops the thread; small folders are deleted before, the rest by the next agent. */
  @Override
  public void close() {
    long end = System.nanoTime() + CLOSE_TIMEOUT.toNanos();
    boolean interrupted = false;
    try {
      synchronized (this) {
        for (long left = CLOSE_TIMEOUT.toMillis();
            (pending || working) && left > 0;
            left = (end - System.nanoTime()) / 1_000_000) {
          wait(left);
        }
      }
    } catch (InterruptedException e) {
      interrupted = true;
    }
    thread.interrupt();
    try {
      thread.join(CLOSE_TIMEOUT.toMillis());
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
