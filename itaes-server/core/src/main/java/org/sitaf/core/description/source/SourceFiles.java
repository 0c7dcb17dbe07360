package org.sitaf.core.description.source;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * The input of the importers: the requested files, and other files that resolve references and
 * types.
 *
 * @param name name of the folder or archive; used as package name if there is no other
 * @param files content by relative path with '/' separators
 * @param requested paths of the files whose interfaces are imported
 * @param includeFolders folders in which included files are searched, in this order
 */
public record SourceFiles(
    String name,
    NavigableMap<String, byte[]> files,
    SortedSet<String> requested,
    List<String> includeFolders) {
  public SourceFiles {
    Objects.requireNonNull(name);
    files = new TreeMap<>(files);
    requested = new TreeSet<>(requested);
    includeFolders = List.copyOf(includeFolders);
    if (!files.keySet().containsAll(requested)) {
      throw new IllegalArgumentException("a requested file does not exist: " + requested);
    }
  }

  /** Creates the input from all files and the requested ones. */
  public static SourceFiles of(String name, Map<String, byte[]> files, List<String> requested) {
    return new SourceFiles(name, new TreeMap<>(files), new TreeSet<>(requested), List.of());
  }

  /** The same files, with folders in which included files are searched. */
  public SourceFiles including(List<String> folders) {
    return new SourceFiles(name, files, requested, folders);
  }

  /** The same files, with the request restricted to matching paths. */
  public SourceFiles requesting(Predicate<String> fits) {
    SortedSet<String> some = new TreeSet<>(requested);
    some.removeIf(fits.negate());
    return new SourceFiles(name, files, some, includeFolders);
  }

  /** All files except those with matching paths. */
  public SourceFiles without(Predicate<String> unwanted) {
    NavigableMap<String, byte[]> rest = new TreeMap<>(files);
    rest.keySet().removeIf(unwanted);
    SortedSet<String> restRequested = new TreeSet<>(requested);
    restRequested.removeIf(unwanted);
    return new SourceFiles(name, rest, restRequested, includeFolders);
  }

  /** Whether the interfaces of a file are imported; otherwise the file only resolves references. */
  public boolean isRequested(String path) {
    return requested.contains(path);
  }

  /** Whether a file is in one of the {@link #includeFolders}, so that it is read where included. */
  public boolean isForInclusion(String path) {
    return includeFolders.stream()
        .anyMatch(folder -> path.startsWith(folder.endsWith("/") ? folder : folder + "/"));
  }

  /** Content of a file. */
  public byte[] content(String path) {
    return Objects.requireNonNull(files.get(path), path);
  }

  /** The content of a file, decoded as UTF-8 without byte order mark. */
  public String text(String path) {
    String text = new String(content(path), StandardCharsets.UTF_8);
    return text.startsWith("\uFEFF") ? text.substring(1) : text;
  }

  /**
   * Resolves a reference: a path relative to the referencing file or to one of the {@link
   * #includeFolders}, or else the only file with that name.
   */
  public Optional<String> resolve(String from, String reference) {
    String plain = reference.strip().replace('\\', '/').replaceFirst("^(\\./)+", "");
    List<String> folders = new ArrayList<>(List.of(from.substring(0, from.lastIndexOf('/') + 1)));
    includeFolders.forEach(
        folder -> folders.add(folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/"));
    for (String folder : folders) {
      String path = normalized(folder + plain);
      if (files.containsKey(path)) {
        return Optional.of(path);
      }
    }
    String last = plain.substring(plain.lastIndexOf('/') + 1);
    List<String> named =
        files.keySet().stream().filter(p -> p.equals(last) || p.endsWith("/" + last)).toList();
    return named.size() == 1 ? Optional.of(named.get(0)) : Optional.empty();
  }

  /** A path without {@code .} and {@code ..}, where they can be removed. */
  private static String normalized(String path) {
    List<String> steps = new ArrayList<>();
    for (String step : path.split("/", -1)) {
      int last = steps.size() - 1;
      if (step.equals("..") && last >= 0 && !steps.get(last).isEmpty()) {
        steps.remove(last);
      } else if (!step.equals(".")) {
        steps.add(step);
      }
    }
    return String.join("/", steps);
  }
}
