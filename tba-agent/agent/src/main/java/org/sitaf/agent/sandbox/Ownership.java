package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.agent.spool.SystemTool;

/** Gives what a process may write to the user that it runs as. */
final class Ownership {
  private static final Duration PATIENCE = Duration.ofMinutes(1);

  private Ownership() {}

  static void giveTo(int user, Confinement confinement) throws IOException {
    List<Path> all = new ArrayList<>(List.of(confinement.working(), confinement.temporary()));
    all.addAll(confinement.writable());
    List<String> full = new ArrayList<>();
    for (Path path : all) {
      if (isFilledFolder(path)) {
        full.add(path.toString());
      } else {
        give(user, path);
      }
    }
    if (!full.isEmpty()) {
      giveTrees(user, full);
    }
    for (Path path : confinement.readable()) {
      if (isSocket(path)) {
        // Its folder is the agent's alone, so that this opens it to the process and to no one else.
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rw-rw-rw-"));
      }
    }
  }

  private static boolean isSocket(Path path) throws IOException {
    BasicFileAttributes attributes =
        Files.readAttributes(path, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    return attributes.isOther();
  }

  private static boolean isFilledFolder(Path path) throws IOException {
    if (!Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    try (DirectoryStream<Path> inside = Files.newDirectoryStream(path)) {
      return inside.iterator().hasNext();
    }
  }

  private static void give(int user, Path path) throws IOException {
    // Never through a link, which a process before may have left for this.
    Files.setAttribute(path, "unix:uid", user, LinkOption.NOFOLLOW_LINKS);
    Files.setAttribute(path, "unix:gid", user, LinkOption.NOFOLLOW_LINKS);
  }

  /** What a process before left may be of any shape, and another one may be changing it. */
  private static void giveTrees(int user, List<String> folders) throws IOException {
    List<String> command = new ArrayList<>(List.of("chown", "-hR", user + ":" + user, "--"));
    command.addAll(folders);
    try {
      SystemTool.run(command, PATIENCE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw (InterruptedIOException) new InterruptedIOException("interrupted").initCause(e);
    }
  }
}
