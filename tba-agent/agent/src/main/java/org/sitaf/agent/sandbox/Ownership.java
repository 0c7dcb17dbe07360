package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;

/** Gives what a process may write to the user that it runs as. */
final class Ownership {
  private Ownership() {}

  static void giveTo(int user, Confinement confinement) throws IOException {
    give(user, confinement.working());
    give(user, confinement.temporary());
    for (Path path : confinement.writable()) {
      give(user, path);
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

  private static void give(int user, Path tree) throws IOException {
    Files.walkFileTree(
        tree,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes)
              throws IOException {
            return change(folder);
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            return change(file);
          }

          private FileVisitResult change(Path path) throws IOException {
            // Never through a link, which a process before may have left for this.
            Files.setAttribute(path, "unix:uid", user, LinkOption.NOFOLLOW_LINKS);
            Files.setAttribute(path, "unix:gid", user, LinkOption.NOFOLLOW_LINKS);
            return FileVisitResult.CONTINUE;
          }
        });
  }
}
