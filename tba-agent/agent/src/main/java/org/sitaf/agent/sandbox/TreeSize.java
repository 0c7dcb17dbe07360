package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SecureDirectoryStream;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;

/**
 * How much lies in folders that somebody changes meanwhile. Each folder is opened below the one
 * that holds it, never through a link, so that a tree of any shape cannot lead elsewhere.
 */
final class TreeSize {
  /** Each level takes a descriptor while it is looked at. */
  static final int DEEPEST = 512;

  private final DiskLimits limits;
  private final List<Path> closed = new ArrayList<>();
  private long bytes;
  private int files;
  private boolean tooDeep;

  /** Nothing yet; counting ends where the limits are exceeded. */
  TreeSize(DiskLimits limits) {
    this.limits = limits;
  }

  TreeSize with(List<Path> roots) {
    roots.forEach(this::add);
    return this;
  }

  long bytes() {
    return bytes;
  }

  int files() {
    return files;
  }

  /** Whether folders are nested so deep that not all could be looked at. */
  boolean isTooDeep() {
    return tooDeep;
  }

  /** Folders that this user may not look into. */
  List<Path> closed() {
    return closed;
  }

  private void add(Path root) {
    try {
      BasicFileAttributes attributes =
          Files.readAttributes(root, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
      if (!attributes.isDirectory()) {
        bytes += attributes.size();
        return;
      }
      try (DirectoryStream<Path> stream = Files.newDirectoryStream(root)) {
        // Other systems than Linux may not have it; components are confined on Linux only.
        if (stream instanceof SecureDirectoryStream<Path> folder) {
          addAllOf(folder, root, 1);
        }
      }
    } catch (AccessDeniedException e) {
      closed.add(root);
    } catch (IOException | DirectoryIteratorException e) {
      // It is gone.
    }
  }

  private void addAllOf(SecureDirectoryStream<Path> folder, Path where, int depth) {
    try {
      for (Path entry : folder) {
        if (files > limits.files() || bytes > limits.bytes()) {
          return;
        }
        addEntry(folder, where, entry.getFileName(), depth);
      }
    } catch (DirectoryIteratorException e) {
      // It goes away while it is looked at.
    }
  }

  private void addEntry(SecureDirectoryStream<Path> folder, Path where, Path name, int depth) {
    files++;
    try {
      BasicFileAttributes attributes =
          folder
              .getFileAttributeView(name, BasicFileAttributeView.class, LinkOption.NOFOLLOW_LINKS)
              .readAttributes();
      if (!attributes.isDirectory()) {
        bytes += attributes.size();
      } else if (depth == DEEPEST) {
        tooDeep = true;
      } else {
        try (SecureDirectoryStream<Path> inner =
            folder.newDirectoryStream(name, LinkOption.NOFOLLOW_LINKS)) {
          addAllOf(inner, where.resolve(name), depth + 1);
        }
      }
    } catch (AccessDeniedException e) {
      closed.add(where.resolve(name));
    } catch (FileSystemException e) {
      tooDeep |= String.valueOf(e.getReason()).contains("Too many open files");
    } catch (IOException e) {
      // It is gone.
    }
  }
}
