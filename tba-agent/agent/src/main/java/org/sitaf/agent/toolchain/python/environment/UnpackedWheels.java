package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.python.environment.WheelCollection.PackageException;
import org.sitaf.core.digest.Sha256;

/**
 * Wheels in a cache, each unpacked and compiled once. Environments are put together from them by
 * hard links, so that files which several environments have in common are kept once. A wheel is
 * unpacked alone, so no other package can change what is kept of it.
 */
record UnpackedWheels(SharedCache cache, Interpreter interpreter) {
  static final String PREFIX = "unpacked-";

  /** Folder of the files in an entry. */
  static final String TREE = "tree";

  /** Increased when wheels are unpacked differently. */
  private static final String LAYOUT = "1";

  /**
   * Unpacks the wheels that are not in the cache.
   *
   * @param pip environment whose pip unpacks
   * @return a folder for each wheel, which has the layout of an environment
   * @throws PackageException if a wheel cannot be installed with this interpreter
   */
  List<Path> of(List<Path> wheels, Path pip, PackageTools tools)
      throws IOException, InterruptedException, PackageException {
    List<Path> entries = new ArrayList<>();
    Map<Path, Path> missing = new LinkedHashMap<>();
    for (Path wheel : wheels) {
      String name = name(wheel);
      Path entry = cache.existing(name).orElse(cache.entry(name));
      entries.add(entry);
      if (Files.isDirectory(entry)) {
        // Not removed before an environment has its files.
        KeptEnvironments.use(entry);
      } else {
        missing.put(entry, wheel);
      }
    }
    if (!missing.isEmpty()) {
      unpack(missing, pip, tools);
    }
    return entries.stream().map(entry -> entry.resolve(TREE)).toList();
  }

  private String name(Path wheel) throws IOException {
    String key =
        String.join("\n", LAYOUT, interpreter.toString(), EnvironmentPackages.digest(wheel));
    return PREFIX + Sha256.hex(key.getBytes(StandardCharsets.UTF_8)).substring(0, 24);
  }

  private void unpack(Map<Path, Path> missing, Path pip, PackageTools tools)
      throws IOException, InterruptedException, PackageException {
    Map<Path, SharedCache.Draft> drafts = new LinkedHashMap<>();
    try {
      Map<Path, Path> trees = new LinkedHashMap<>();
      for (Map.Entry<Path, Path> each : missing.entrySet()) {
        SharedCache.Draft draft = cache.draft();
        drafts.put(each.getKey(), draft);
        Environments.makeReadable(draft.folder());
        Path tree = Files.createDirectory(draft.folder().resolve(TREE));
        Environments.makeReadable(tree);
        trees.put(each.getValue(), tree);
      }
      ToolResult unpacked = tools.unpack(pip, trees);
      if (unpacked.code() != 0) {
        throw new PackageException(tools.errorOf(unpacked));
      }
      for (Map.Entry<Path, SharedCache.Draft> each : drafts.entrySet()) {
        Path folder = each.getValue().folder();
        Environments.takeOwnership(folder, cache);
        KeptEnvironments.measure(folder);
        each.getValue().addAs(each.getKey().getFileName().toString());
      }
    } finally {
      for (SharedCache.Draft draft : drafts.values()) {
        draft.close();
      }
    }
  }

  /**
   * Adds the files of a folder to another one. What is there already stays.
   *
   * @throws PackageException if one of the folders has a file where the other has a folder
   */
  static void link(Path from, Path into) throws IOException, PackageException {
    try {
      Files.walkFileTree(
          from,
          new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes)
                throws IOException {
              Files.createDirectories(into.resolve(from.relativize(folder).toString()));
              return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
                throws IOException {
              if (attributes.isRegularFile()) {
                linkFile(file, into.resolve(from.relativize(file).toString()));
              }
              return FileVisitResult.CONTINUE;
            }
          });
    } catch (FileAlreadyExistsException e) {
      throw new PackageException(
          "two of the packages contain "
              + into.relativize(Path.of(e.getFile()))
              + ", one as a file and one as a folder");
    }
  }

  /** Makes a file appear at another place as well, unless something is there. */
  static void linkFile(Path file, Path place) throws IOException {
    try {
      Files.createLink(place, file);
    } catch (FileAlreadyExistsException e) {
      if (Files.isDirectory(place)) {
        throw e;
      }
    } catch (IOException | UnsupportedOperationException e) {
      // Other file systems have no links, not so many to one file, or none to another user's file.
      // Compiled modules are valid for the time of their sources.
      Files.copy(file, place, StandardCopyOption.COPY_ATTRIBUTES);
    }
  }
}
