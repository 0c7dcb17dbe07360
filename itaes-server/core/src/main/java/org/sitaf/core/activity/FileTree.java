package org.sitaf.core.activity;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * Files by relative path, sorted by path. Paths have '/' separators and no empty, '.' or '..'
 * parts, so a tree can be safely written to any folder.
 */
public final class FileTree {
  /** Control characters, including bidirectional controls that disguise a name. */
  private static final Pattern CONTROL =
      Pattern.compile("[\\p{Cc}\\p{Cs}\\u2028\\u2029\\u200E\\u200F\\u202A-\\u202E\\u2066-\\u2069]");

  private static final int MAX_PATH_LENGTH = 400;
  private static final int MAX_DEPTH = 50;
  private static final int SHOWN = 100;

  /** In bytes of UTF-8, as in common file systems. */
  private static final int MAX_NAME_BYTES = 255;

  private final NavigableMap<String, byte[]> files;

  private FileTree(NavigableMap<String, byte[]> files) {
    this.files = Collections.unmodifiableNavigableMap(files);
  }

  /**
   * Creates a tree.
   *
   * @throws IllegalArgumentException if a path is unsafe or is both a file and a folder
   */
  public static FileTree of(Map<String, byte[]> files) {
    NavigableMap<String, byte[]> sorted = new TreeMap<>();
    files.forEach((path, content) -> sorted.put(requireSafe(path), content.clone()));
    for (String path : sorted.keySet()) {
      String inside = sorted.higherKey(path + "/");
      if (sorted.containsKey(path + "/") || (inside != null && inside.startsWith(path + "/"))) {
        throw new IllegalArgumentException("'" + path + "' is both a file and a folder");
      }
    }
    return new FileTree(sorted);
  }

  /**
   * Checks a path.
   *
   * @throws IllegalArgumentException if the path is unsafe or not a valid file path
   */
  public static String requireSafe(String path) {
    boolean bad =
        path.isEmpty()
            || path.length() > MAX_PATH_LENGTH
            || path.indexOf('\\') >= 0
            || CONTROL.matcher(path).find()
            || Arrays.stream(path.split("/", -1))
                .anyMatch(part -> part.isEmpty() || part.equals(".") || part.equals(".."));
    if (!bad) {
      requireWritable(path);
    }
    if (bad) {
      throw new IllegalArgumentException(
          "'"
              + shown(path)
              + "' is not a relative path of at most "
              + MAX_PATH_LENGTH
              + " characters with '/' separators, without '.' or '..' parts and control"
              + " characters");
    }
    return path;
  }

  /** A path for messages, shortened and without control characters. */
  private static String shown(String path) {
    String plain = CONTROL.matcher(path).replaceAll("?");
    return plain.length() <= SHOWN ? plain : plain.substring(0, SHOWN) + "...";
  }

  private static void requireWritable(String path) {
    String[] parts = path.split("/", -1);
    if (parts.length > MAX_DEPTH) {
      throw new IllegalArgumentException(
          "'" + shown(path) + "' is nested more than " + MAX_DEPTH + " folders deep");
    }
    for (String part : parts) {
      if (part.getBytes(StandardCharsets.UTF_8).length > MAX_NAME_BYTES) {
        throw new IllegalArgumentException(
            "'"
                + shown(part)
                + "' is longer than the maximum length of a file name, "
                + MAX_NAME_BYTES
                + " bytes");
      }
    }
  }

  /** All paths in sorted order. */
  public NavigableSet<String> paths() {
    return files.navigableKeySet();
  }

  /** Whether a file exists. */
  public boolean contains(String path) {
    return files.containsKey(path);
  }

  /** A copy of the content of a file. */
  public Optional<byte[]> content(String path) {
    return Optional.ofNullable(files.get(path)).map(byte[]::clone);
  }

  /** The content of a file, decoded as UTF-8. */
  public Optional<String> text(String path) {
    return Optional.ofNullable(files.get(path)).map(b -> new String(b, StandardCharsets.UTF_8));
  }

  /** The content of a file as a stream. */
  public Optional<InputStream> open(String path) {
    return Optional.ofNullable(files.get(path)).map(ByteArrayInputStream::new);
  }

  /** The files below a folder, with paths relative to the folder. */
  public FileTree below(String folder) {
    String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
    NavigableMap<String, byte[]> inside = new TreeMap<>();
    files
        .tailMap(prefix, false)
        .forEach(
            (path, content) -> {
              if (path.startsWith(prefix)) {
                inside.put(path.substring(prefix.length()), content);
              }
            });
    return new FileTree(inside);
  }

  /** A copy with the files of another tree added below a folder; these replace existing files. */
  public FileTree with(String folder, FileTree other) {
    Map<String, byte[]> all = new HashMap<>(files);
    String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
    other.files.forEach((path, content) -> all.put(prefix + path, content));
    return of(all);
  }

  /** A copy with a file added or replaced. */
  public FileTree with(String path, byte[] content) {
    Map<String, byte[]> all = new HashMap<>(files);
    all.put(path, content);
    return of(all);
  }

  /** The size of all files in bytes. */
  public long size() {
    return files.values().stream().mapToLong(content -> content.length).sum();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof FileTree tree
        && files.keySet().equals(tree.files.keySet())
        && files.entrySet().stream()
            .allMatch(e -> Arrays.equals(e.getValue(), tree.files.get(e.getKey())));
  }

  @Override
  public int hashCode() {
    return files.keySet().hashCode();
  }

  @Override
  public String toString() {
    return "FileTree" + files.keySet();
  }
}
