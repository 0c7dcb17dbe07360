package org.sitaf.cli.describe;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Reads interface files from the command line: files, folders, zip archives. */
public final class InterfaceSources {
  private static final int MAX_FOLDERS = 20;
  private static final int MAX_FILES = 10_000;

  /** Folders of a ROS 2 package; message types are in the first one. */
  private static final Set<String> ROS_FOLDERS = Set.of("msg", "srv", "action");

  private InterfaceSources() {}

  /**
   * A parsed description.
   *
   * @param shown name of each file as the user knows it
   */
  public record Source(ImportResult result, Map<String, String> shown) {
    public Source {
      shown = Map.copyOf(shown);
    }

    /** The name of a file as the user knows it. */
    public String show(String file) {
      return shown.getOrDefault(file, file);
    }

    /** The diagnostics, with file names as the user knows them. */
    public List<Diagnostic> diagnostics() {
      return result.diagnostics().stream()
          .map(
              d -> new Diagnostic(d.severity(), show(d.file()), d.line(), d.element(), d.message()))
          .toList();
    }
  }

  /**
   * Reads all given paths. Single files are read together, so that one may refer to another; each
   * folder or archive is read separately.
   *
   * @param includes folders in which included IDL files are searched
   * @throws InvalidInputException if a path cannot be read
   */
  public static List<Source> read(List<Path> named, List<Path> includes) {
    List<Path> single = new ArrayList<>();
    List<Source> sources = new ArrayList<>();
    for (Path path : named) {
      if (Files.isDirectory(path)) {
        sources.add(folder(path, includes));
      } else if (path.toString().endsWith(".zip")) {
        sources.add(archive(path));
      } else {
        single.add(path);
      }
    }
    if (!single.isEmpty()) {
      sources.add(files(single, includes));
    }
    return sources;
  }

  private static Source archive(Path path) {
    try (InputStream in = Files.newInputStream(path)) {
      FileTree tree = ActivityArchive.read(in, path.toString());
      Map<String, byte[]> files = new HashMap<>();
      Map<String, String> shown = new HashMap<>();
      for (String file : tree.paths()) {
        files.put(file, tree.content(file).orElseThrow());
        shown.put(file, path + "/" + file);
      }
      String name = String.valueOf(path.getFileName()).replaceFirst("\\.zip$", "");
      shown.put(name, path.toString());
      return new Source(InterfaceFiles.readAll(name, files), shown);
    } catch (IOException e) {
      throw unreadable(path, e);
    }
  }

  private static Source folder(Path folder, List<Path> includes) {
    Map<String, byte[]> files = new HashMap<>();
    Map<String, String> shown = new HashMap<>();
    for (Path path : interfaceFilesBelow(folder)) {
      String name = folder.relativize(path).toString().replace('\\', '/');
      files.put(name, content(path));
      shown.put(name, path.toString());
    }
    List<String> asked = List.copyOf(files.keySet());
    addIncluded(includes, files, shown);
    String name = String.valueOf(folder.toAbsolutePath().normalize().getFileName());
    shown.put(name, folder.toString());
    SourceFiles sources = SourceFiles.of(name, files, asked).including(keys(includes));
    return new Source(InterfaceFiles.readAll(sources), shown);
  }

  /** The interface files in a folder and its subfolders, without hidden ones. */
  private static List<Path> interfaceFilesBelow(Path folder) {
    List<Path> found = new ArrayList<>();
    try (Stream<Path> all = Files.walk(folder, MAX_FOLDERS)) {
      for (Path path : (Iterable<Path>) all::iterator) {
        String name = folder.relativize(path).toString().replace('\\', '/');
        if (name.startsWith(".") || name.contains("/.") || !isWanted(path)) {
          continue;
        }
        if (found.size() >= MAX_FILES) {
          throw InvalidInputException.of(
              folder.toString(),
              "contains more than " + MAX_FILES + " interface files; name a subfolder");
        }
        found.add(path);
      }
    } catch (UncheckedIOException e) {
      throw unreadable(folder, e.getCause());
    } catch (IOException e) {
      throw unreadable(folder, e);
    }
    return found;
  }

  private static void addIncluded(
      List<Path> includes, Map<String, byte[]> files, Map<String, String> shown) {
    for (Path folder : includes) {
      if (!Files.isDirectory(folder)) {
        throw InvalidInputException.of(folder.toString(), "is not a folder; -I needs one");
      }
      for (Path path : interfaceFilesBelow(folder)) {
        if (path.toString().endsWith(".idl") && isSmall(path)) {
          files.put(key(path), content(path));
          shown.put(key(path), path.toString());
        }
      }
    }
  }

  private static List<String> keys(List<Path> folders) {
    return folders.stream().map(InterfaceSources::key).toList();
  }

  /** Files by absolute path, with the files next to them, which they may refer to. */
  private static Source files(List<Path> named, List<Path> includes) {
    Map<String, byte[]> files = new HashMap<>();
    Map<String, String> shown = new HashMap<>();
    List<String> asked = new ArrayList<>();
    for (Path path : named) {
      if (!Files.exists(path)) {
        throw InvalidInputException.of(path.toString(), "does not exist");
      }
      String key = key(path);
      files.put(key, content(path));
      shown.put(key, path.toString());
      asked.add(key);
      for (Path other : siblings(path)) {
        if (!files.containsKey(key(other)) && isSmall(other)) {
          files.put(key(other), content(other));
          shown.put(key(other), other.toString());
        }
      }
    }
    addIncluded(includes, files, shown);
    SourceFiles sources = SourceFiles.of("", files, asked).including(keys(includes));
    return new Source(InterfaceFiles.read(sources), shown);
  }

  private static List<Path> siblings(Path path) {
    Path folder = path.toAbsolutePath().normalize().getParent();
    if (folder == null) {
      return List.of();
    }
    List<Path> found = new ArrayList<>(interfaceFilesIn(folder));
    if (ROS_FOLDERS.contains(String.valueOf(folder.getFileName()))) {
      found.addAll(interfaceFilesIn(folder.resolveSibling("msg")));
      found.addAll(interfaceFilesIn(folder.resolveSibling("package.xml")));
    }
    return found;
  }

  private static List<Path> interfaceFilesIn(Path folder) {
    if (!Files.isDirectory(folder)) {
      return isWanted(folder) ? List.of(folder) : List.of();
    }
    try (Stream<Path> all = Files.list(folder)) {
      return all.filter(InterfaceSources::isWanted).sorted().limit(MAX_FILES).toList();
    } catch (IOException e) {
      throw unreadable(folder, e);
    }
  }

  private static boolean isWanted(Path path) {
    return InterfaceFiles.isSupported(path.toString())
        && Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS);
  }

  private static boolean isSmall(Path path) {
    try {
      return Files.size(path) <= InterfaceFiles.MAX_SIZE;
    } catch (IOException e) {
      throw unreadable(path, e);
    }
  }

  private static byte[] content(Path path) {
    try {
      if (!isSmall(path)) {
        throw InvalidInputException.of(
            path.toString(),
            "is larger than " + (InterfaceFiles.MAX_SIZE >> 20) + " MiB; split it");
      }
      return Files.readAllBytes(path);
    } catch (IOException e) {
      throw unreadable(path, e);
    }
  }

  private static String key(Path path) {
    return path.toAbsolutePath().normalize().toString().replace('\\', '/');
  }

  private static InvalidInputException unreadable(Path path, IOException e) {
    return InvalidInputException.of(path.toString(), "cannot be read: " + e.getMessage());
  }
}
