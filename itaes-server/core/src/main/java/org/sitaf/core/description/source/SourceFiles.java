package org.sitaf.core.description.source;

import java.nio.charset.StandardCharsets;
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
 * Files from which interfaces are read: those that were asked for, and others beside them, where
 * references and types may lead.
 *
 * @param name of the whole, such as its folder; where a package has no other name
 * @param files content by relative path with '/' separators
 * @param asked paths of the files whose interfaces are wanted
 */
public record SourceFiles(
    String name, NavigableMap<String, byte[]> files, SortedSet<String> asked) {
  public SourceFiles {
    Objects.requireNonNull(name);
    files = new TreeMap<>(files);
    asked = new TreeSet<>(asked);
    if (!files.keySet().containsAll(asked)) {
      throw new IllegalArgumentException("asked for a file that is not there: " + asked);
    }
  }

  /** Files of which only some are asked for. */
  public static SourceFiles of(String name, Map<String, byte[]> files, List<String> asked) {
    return new SourceFiles(name, new TreeMap<>(files), new TreeSet<>(asked));
  }

  /** The same files, of which only those are asked for whose path fits. */
  public SourceFiles asking(Predicate<String> fits) {
    SortedSet<String> some = new TreeSet<>(asked);
    some.removeIf(fits.negate());
    return new SourceFiles(name, files, some);
  }

  /** The other files. */
  public SourceFiles without(Predicate<String> unwanted) {
    NavigableMap<String, byte[]> rest = new TreeMap<>(files);
    rest.keySet().removeIf(unwanted);
    SortedSet<String> restAsked = new TreeSet<>(asked);
    restAsked.removeIf(unwanted);
    return new SourceFiles(name, rest, restAsked);
  }

  /** Whether this file's interfaces are wanted; otherwise it only helps to understand others. */
  public boolean isAsked(String path) {
    return asked.contains(path);
  }

  /** Content of a file. */
  public byte[] content(String path) {
    return Objects.requireNonNull(files.get(path), path);
  }

  /** A file as text in UTF-8, a byte order mark left out. */
  public String text(String path) {
    String text = new String(content(path), StandardCharsets.UTF_8);
    return text.startsWith("\uFEFF") ? text.substring(1) : text;
  }

  /**
   * The file that a reference in another file means: relative to that file, else the only one of
   * that name.
   */
  public Optional<String> referred(String from, String reference) {
    String plain = reference.strip().replace('\\', '/').replaceFirst("^(\\./)+", "");
    String beside = from.substring(0, from.lastIndexOf('/') + 1) + plain;
    if (files.containsKey(beside)) {
      return Optional.of(beside);
    }
    String last = plain.substring(plain.lastIndexOf('/') + 1);
    List<String> named =
        files.keySet().stream().filter(p -> p.equals(last) || p.endsWith("/" + last)).toList();
    return named.size() == 1 ? Optional.of(named.get(0)) : Optional.empty();
  }
}
