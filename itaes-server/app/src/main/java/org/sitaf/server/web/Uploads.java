package org.sitaf.server.web;

import jakarta.servlet.http.HttpServletRequest;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.LimitSettings;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;

/**
 * Receives uploaded archives of activities. An archive is first saved to a file and then unpacked
 * in memory; the number of archives that are unpacked concurrently is limited.
 */
@Component
public class Uploads {
  private static final int MAX_WAITING = 16;
  private static final long WAIT_S = 20;

  /** An archive may take this fraction of the heap. */
  private static final int HEAP_FRACTION = 8;

  private final Requests requests;
  private final Path folder;
  private final Semaphore unpacking;
  private final long maxUnpacked;

  Uploads(Requests requests, SitafSettings settings, LimitSettings limits) {
    this.requests = requests;
    this.folder = settings.dataDirectory().resolve("uploads");
    this.unpacking = new Semaphore(limits.uploadsAtOnce(), true);
    this.maxUnpacked =
        Math.min(ActivityArchive.MAX_SIZE, Runtime.getRuntime().maxMemory() / HEAP_FRACTION);
  }

  /** Deletes files that a killed server left. */
  @EventListener
  void on(ApplicationReadyEvent ready) throws IOException {
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> left = Files.newDirectoryStream(folder, "upload-*")) {
        for (Path file : left) {
          Files.deleteIfExists(file);
        }
      }
    }
  }

  /**
   * Unpacks the archive in a request's body and applies a function to its files.
   *
   * @throws RequestException if the body is incomplete or the server is busy
   */
  public <T> T unpack(HttpServletRequest request, Function<FileTree, T> use) throws IOException {
    return unpack(request, ActivityArchive::read, use);
  }

  /**
   * Unpacks the archive in a request's body, with a top-level folder that contains all files, and
   * applies a function to its files.
   *
   * @throws RequestException if the body is incomplete or the server is busy
   */
  public <T> T unpackWhole(HttpServletRequest request, Function<FileTree, T> use)
      throws IOException {
    return unpack(request, ActivityArchive::readWhole, use);
  }

  private interface Reading {
    FileTree read(InputStream zip, String name, long maxSize);
  }

  private <T> T unpack(HttpServletRequest request, Reading reading, Function<FileTree, T> use)
      throws IOException {
    Files.createDirectories(folder);
    Path file = Files.createTempFile(folder, "upload-", ".zip");
    try {
      try (InputStream body = requests.body(request);
          OutputStream out = Files.newOutputStream(file)) {
        body.transferTo(out);
      }
      acquire();
      try (InputStream zip = new BufferedInputStream(Files.newInputStream(file))) {
        return use.apply(reading.read(zip, "the uploaded archive", maxUnpacked));
      } finally {
        unpacking.release();
      }
    } finally {
      Files.deleteIfExists(file);
    }
  }

  private void acquire() {
    try {
      if (unpacking.getQueueLength() < MAX_WAITING
          && unpacking.tryAcquire(WAIT_S, TimeUnit.SECONDS)) {
        return;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw RequestException.busy(
        "The server is busy with other uploads; try again in some seconds.");
  }
}
