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

/** Changes the owner of the files that a confined process may write. */
final class Ownership {
  private static final Duration CHOWN_TIMEOUT = Duration.ofMinutes(1);

  private Ownership() {}

  static void transferTo(int user, Confinement confinement) throws IOException {
    List<Path> all = new ArrayList<>(List.of(confinement.working(), confinement.temporary()));
    all.addAll(confinement.writable());
    List<String> trees = new ArrayList<>();
    for (Path path : all) {
      if (isNonEmptyFolder(path)) {
        trees.add(path.toString());
      } else {
        chown(user, path);
      }
    }
    if (!trees.isEmpty()) {
      chownTrees(user, trees);
    }
    for (Path path : confinement.readable()) {
      if (isSocket(path)) {
        // The socket's folder is accessible to the agent only, so no other process can reach the
        // socket.
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rw-rw-rw-"));
      }
    }
  }

  private static boolean isSocket(Path path) throws IOException {
    BasicFileAttributes attributes =
        Files.readAttributes(path, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    return attributes.isOther();
  }

  private static boolean isNonEmptyFolder(Path path) throws IOException {
    if (!Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    try (DirectoryStream<Path> inside = Files.newDirectoryStream(path)) {
      return inside.iterator().hasNext();
    }
  }

  private static void chown(int user, Path path) throws IOException {
    // NOFOLLOW_LINKS: an earlier process may have replaced the file by a link.
    Files.setAttribute(path, "unix:uid", user, LinkOption.NOFOLLOW_LINKS);
    Files.setAttribute(path, "unix:gid", user, LinkOption.NOFOLLOW_LINKS);
  }

  /** Uses {@code chown}, which is safe on trees that another process changes at the same time. */
  private static void chownTrees(int user, List<String> folders) throws IOException {
    List<String> command = new ArrayList<>(List.of("chown", "-hR", user + ":" + user, "--"));
    command.addAll(folders);
    try {
      SystemTool.run(command, CHOWN_TIMEOUT);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw (InterruptedIOException) new InterruptedIOException("interrupted").initCause(e);
    }
  }
}
