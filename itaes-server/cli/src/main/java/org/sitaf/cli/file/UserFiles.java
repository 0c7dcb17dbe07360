package org.sitaf.cli.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Reads files that are named on the command line. */
public final class UserFiles {
  private static final int MAX_DEPTH = 20;

  private UserFiles() {}

  /**
   * Reads a folder tree without hidden files and folders.
   *
   * @throws InvalidInputException if the folder does not exist, contains a link, or is too large
   */
  public static FileTree folder(Path folder) {
    if (!Files.isDirectory(folder)) {
      throw InvalidInputException.of(folder.toString(), "is not a folder");
    }
    Map<String, byte[]> files = new HashMap<>();
    long size = 0;
    try (Stream<Path> all = Files.walk(folder, MAX_DEPTH)) {
      for (Path path : (Iterable<Path>) all::iterator) {
        String name = folder.relativize(path).toString().replace('\\', '/');
        if (name.startsWith(".") || name.contains("/.")) {
          continue;
        }
        if (Files.isSymbolicLink(path)) {
          throw InvalidInputException.of(
              path.toString(), "is a link; copy the file into the activity");
        }
        if (Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
          size += Files.size(path);
          if (size > ActivityArchive.MAX_SIZE || files.size() >= ActivityArchive.MAX_FILES) {
            throw InvalidInputException.of(
                folder.toString(),
                "holds more than %d files or %d MiB, the limit of an activity; move what the test does not need out of it"
                    .formatted(ActivityArchive.MAX_FILES, ActivityArchive.MAX_SIZE >> 20));
          }
          files.put(name, Files.readAllBytes(path));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    try {
      return FileTree.of(files);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(folder.toString(), String.valueOf(e.getMessage()));
    }
  }

  /**
   * Reads a file.
   *
   * @throws InvalidInputException if it cannot be read
   */
  public static byte[] file(Path file) {
    if (Files.isDirectory(file)) {
      throw InvalidInputException.of(file.toString(), "is a folder; name a file");
    }
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw InvalidInputException.of(
          file.toString(),
          Files.exists(file) ? "cannot be read: " + e.getMessage() : "does not exist");
    }
  }

  /**
   * Checks that a file can be written.
   *
   * @param option the option that names it
   * @throws InvalidInputException when it is a folder, or its folder cannot be written to
   */
  public static void requireWritableFile(String option, Path file) {
    if (Files.isDirectory(file)) {
      throw InvalidInputException.of(option + " " + file, "is a folder; name a file");
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || !Files.isDirectory(folder)) {
      throw InvalidInputException.of(
          option + " " + file, "the folder " + folder + " does not exist; create it");
    }
    if (!Files.isWritable(Files.exists(file) ? file : folder)) {
      throw InvalidInputException.of(option + " " + file, "cannot be written");
    }
  }

  /**
   * Creates a folder where there is none.
   *
   * @param option the option that names it
   * @throws InvalidInputException when it is a file, or cannot be created or written to
   */
  public static void requireWritableFolder(String option, Path folder) {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw InvalidInputException.of(
          option + " " + folder, "is a file; name a folder for the files of all models");
    }
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw InvalidInputException.of(option + " " + folder, "cannot be created: " + e);
    }
    if (!Files.isWritable(folder)) {
      throw InvalidInputException.of(option + " " + folder, "cannot be written to");
    }
  }
}
