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
 * Size of folders that other processes may change during the measurement. Each folder is opened
 * relative to its parent and never through a link, so the traversal cannot leave the tree.
 */
final class TreeSize {
  /** Each level holds an open descriptor during the measurement. */
  static final int MAX_DEPTH = 512;

  private final DiskLimits limits;
  private final List<Path> unreadable = new ArrayList<>();
  private long bytes;
  private int files;
  private boolean tooDeep;

  /** An empty measurement; it stops where the limits are exceeded. */
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

  /** Whether folders are nested too deep to be measured completely. */
  boolean isTooDeep() {
    return tooDeep;
  }

  /** Folders that this user may not read. */
  List<Path> unreadable() {
    return unreadable;
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
        // Other systems than Linux may not support this; components are confined on Linux only.
        if (stream instanceof SecureDirectoryStream<Path> folder) {
          addEntries(folder, root, 1);
        }
      }
    } catch (AccessDeniedException e) {
      unreadable.add(root);
    } catch (IOException | DirectoryIteratorException e) {
      // The folder is gone.
    }
  }

  private void addEntries(SecureDirectoryStream<Path> folder, Path where, int depth) {
    try {
      for (Path entry : folder) {
        if (files > limits.files() || bytes > limits.bytes()) {
          return;
        }
        addEntry(folder, where, entry.getFileName(), depth);
      }
    } catch (DirectoryIteratorException e) {
      // The folder is deleted at this moment.
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
      } else if (depth == MAX_DEPTH) {
        tooDeep = true;
      } else {
        try (SecureDirectoryStream<Path> inner =
            folder.newDirectoryStream(name, LinkOption.NOFOLLOW_LINKS)) {
          addEntries(inner, where.resolve(name), depth + 1);
        }
      }
    } catch (AccessDeniedException e) {
      unreadable.add(where.resolve(name));
    } catch (FileSystemException e) {
      tooDeep |= String.valueOf(e.getReason()).contains("Too many open files");
    } catch (IOException e) {
      // The entry is gone.
    }
  }
}
