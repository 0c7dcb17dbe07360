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
 * Takes folders out of the way by one rename, however large or odd they are, and deletes them later
 * in a thread of its own. What an agent did not come to delete, the next one does.
 */
public final class Trash implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration PATIENCE = Duration.ofMinutes(30);
  private static final Duration END = Duration.ofSeconds(3);

  private final Path folder;
  private final Set<Path> hopeless = new HashSet<>();
  private final Thread thread = new Thread(this::work, "sitaf-trash");
  private boolean news = true;
  private boolean working;

  private Trash(Path folder) {
    this.folder = folder;
    thread.setDaemon(true);
  }

  /** Opens it, and begins to delete what is in it already. */
  static Trash open(Path folder) throws IOException {
    Files.createDirectories(folder);
    Trash trash = new Trash(folder);
    trash.thread.start();
    return trash;
  }

  /**
   * Moves a folder away; its path is free when this returns.
   *
   * @param path on the same disk as this
   */
  public void take(Path path) throws IOException {
    Files.move(path, folder.resolve(UUID.randomUUID().toString()), StandardCopyOption.ATOMIC_MOVE);
    synchronized (this) {
      news = true;
      notifyAll();
    }
  }

  private void work() {
    try {
      while (true) {
        synchronized (this) {
          working = false;
          notifyAll();
          while (!news) {
            wait();
          }
          news = false;
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
        if (!hopeless.contains(path)) {
          delete(path);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      LOGGER.log(System.Logger.Level.WARNING, folder + " cannot be read: " + e.getMessage());
    }
  }

  private void delete(Path path) throws InterruptedException {
    try {
      Folders.deleteByTool(path, PATIENCE);
    } catch (IOException e) {
      hopeless.add(path);
      LOGGER.log(
          System.Logger.Level.WARNING,
          path + " cannot be deleted: " + e.getMessage() + "; please delete it");
    }
  }

  /** Ends; what is small is deleted before, the rest stays for the next agent. */
  @Override
  public void close() {
    long end = System.nanoTime() + END.toNanos();
    boolean interrupted = false;
    try {
      synchronized (this) {
        for (long left = END.toMillis();
            (news || working) && left > 0;
            left = (end - System.nanoTime()) / 1_000_000) {
          wait(left);
        }
      }
    } catch (InterruptedException e) {
      interrupted = true;
    }
    thread.interrupt();
    try {
      thread.join(END.toMillis());
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
