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
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.LimitSettings;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;

/**
 * Takes the archives of activities. They arrive in a file, at their senders' pace, and are unpacked
 * in memory, a few at the same time.
 */
@Component
public class Uploads {
  private static final int MOST_WAITING = 16;
  private static final long PATIENCE_S = 20;

  /** Of the memory that there is, for the files of one archive. */
  private static final int PART_OF_MEMORY = 8;

  private final Requests requests;
  private final Path folder;
  private final Semaphore unpacking;
  private final long maxUnpacked;

  Uploads(Requests requests, SitafSettings settings, LimitSettings limits) {
    this.requests = requests;
    this.folder = settings.dataDirectory().resolve("uploads");
    this.unpacking = new Semaphore(limits.uploadsAtOnce(), true);
    this.maxUnpacked =
        Math.min(ActivityArchive.MAX_SIZE, Runtime.getRuntime().maxMemory() / PART_OF_MEMORY);
  }

  /** What a server that was killed has left. */
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
   * Does something with the archive in the body of a request.
   *
   * @throws Refusal when it does not arrive, or too many others are worked on
   */
  public <T> T unpack(HttpServletRequest request, Function<FileTree, T> use) throws IOException {
    Files.createDirectories(folder);
    Path file = Files.createTempFile(folder, "upload-", ".zip");
    try {
      try (InputStream body = requests.body(request);
          OutputStream out = Files.newOutputStream(file)) {
        body.transferTo(out);
      }
      takeTurn();
      try (InputStream zip = new BufferedInputStream(Files.newInputStream(file))) {
        return use.apply(ActivityArchive.read(zip, "the uploaded archive", maxUnpacked));
      } finally {
        unpacking.release();
      }
    } finally {
      Files.deleteIfExists(file);
    }
  }

  private void takeTurn() {
    try {
      if (unpacking.getQueueLength() < MOST_WAITING
          && unpacking.tryAcquire(PATIENCE_S, TimeUnit.SECONDS)) {
        return;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw Refusal.busy("The server unpacks as many archives as it can; try again in some seconds.");
  }
}
