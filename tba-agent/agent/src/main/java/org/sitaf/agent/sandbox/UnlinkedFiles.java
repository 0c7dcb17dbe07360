package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Files that are deleted but still open or mapped: they occupy disk space and no folder lists them.
 */
final class UnlinkedFiles {
  private static final String DELETED = " (deleted)";

  /** Start and end in hexadecimal, permissions, offset, device, inode, path. */
  private static final Pattern MAPPING =
      Pattern.compile("([0-9a-f]+)-([0-9a-f]+) \\S+ \\S+ (\\S+ \\d+)\\s+(/.*)");

  /** Entries to read per process. */
  private static final int MAX_ENTRIES = 10_000;

  private final List<Path> folders;
  private final Map<Object, Long> sizes = new HashMap<>();
  private boolean hidden;

  private UnlinkedFiles(List<Path> folders) {
    this.folders = folders;
  }

  /** Finds those that were in these folders. */
  static UnlinkedFiles of(Stream<ProcessHandle> processes, List<Path> folders) {
    UnlinkedFiles found = new UnlinkedFiles(folders);
    processes.forEach(
        process -> {
          Path proc = Path.of("/proc", Long.toString(process.pid()));
          found.addOpen(proc.resolve("fd"));
          found.addMapped(proc.resolve("maps"));
        });
    return found;
  }

  long bytes() {
    return sizes.values().stream().mapToLong(size -> size).sum();
  }

  /** Whether a process prevents this user from listing its open files. */
  boolean areHidden() {
    return hidden;
  }

  private void addOpen(Path descriptors) {
    int count = 0;
    try (DirectoryStream<Path> links = Files.newDirectoryStream(descriptors)) {
      for (Path link : links) {
        if (++count > MAX_ENTRIES) {
          return;
        }
        addOpenFile(link);
      }
    } catch (AccessDeniedException e) {
      hidden = true;
    } catch (IOException | DirectoryIteratorException e) {
      // The process has ended.
    }
  }

  private void addOpenFile(Path link) {
    try {
      if (isDeletedFile(Files.readSymbolicLink(link).toString())) {
        Map<String, Object> file = Files.readAttributes(link, "unix:dev,ino,size,isRegularFile");
        if (Boolean.TRUE.equals(file.get("isRegularFile"))) {
          sizes.merge(file.get("ino"), (Long) file.get("size"), Math::max);
        }
      }
    } catch (IOException e) {
      // The descriptor was closed.
    }
  }

  private void addMapped(Path maps) {
    try (Stream<String> lines = Files.lines(maps, StandardCharsets.ISO_8859_1)) {
      lines.limit(MAX_ENTRIES).filter(line -> line.endsWith(DELETED)).forEach(this::addMapping);
    } catch (IOException | java.io.UncheckedIOException e) {
      // The process has ended.
    }
  }

  private void addMapping(String line) {
    Matcher mapping = MAPPING.matcher(line);
    if (mapping.matches() && isDeletedFile(mapping.group(4))) {
      String device = mapping.group(3);
      Object inode = Long.parseLong(device.substring(device.indexOf(' ') + 1));
      long size =
          Long.parseUnsignedLong(mapping.group(2), 16)
              - Long.parseUnsignedLong(mapping.group(1), 16);
      sizes.merge(inode, size, Math::max);
    }
  }

  private boolean isDeletedFile(String path) {
    return path.endsWith(DELETED)
        && folders.stream().anyMatch(folder -> path.startsWith(folder + "/"));
  }
}
