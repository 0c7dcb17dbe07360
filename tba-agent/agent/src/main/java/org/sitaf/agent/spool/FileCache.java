package org.sitaf.agent.spool;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.core.digest.Sha256;

/** Files by the SHA-256 of their content. Files appear in the cache by an atomic rename. */
public final class FileCache {
  private static final Pattern SHA256 = Pattern.compile("[0-9a-f]{64}");
  private static final LeastRecentlyUsed BOUNDS =
      new LeastRecentlyUsed(1L << 30, Integer.MAX_VALUE);

  private final Path directory;

  private FileCache(Path directory) {
    this.directory = directory;
  }

  /** Opens a cache, and removes the least recently used files until it holds at most 1 GiB. */
  static FileCache open(Path directory) throws IOException {
    Files.createDirectories(directory);
    List<Path> kept = new ArrayList<>();
    try (Stream<Path> files = Files.list(directory)) {
      for (Path file : (Iterable<Path>) files::iterator) {
        if (SHA256.matcher(file.getFileName().toString()).matches()) {
          kept.add(file);
        } else {
          Files.delete(file);
        }
      }
    }
    BOUNDS.shrink(kept, file -> file.toFile().length(), Files::deleteIfExists);
    return new FileCache(directory);
  }

  /** Provides the content of a file. */
  @FunctionalInterface
  public interface Source {
    /** Writes the whole content. */
    void writeTo(OutputStream out) throws IOException;
  }

  /** The content of a file, if it is cached and matches its digest. */
  public Optional<byte[]> find(String sha256) throws IOException {
    Path file = path(sha256);
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    byte[] content = Files.readAllBytes(file);
    if (!Sha256.hex(content).equals(sha256)) {
      Files.deleteIfExists(file);
      return Optional.empty();
    }
    LeastRecentlyUsed.touch(file);
    return Optional.of(content);
  }

  /**
   * Adds a file.
   *
   * @throws IOException if the content does not match the digest
   */
  public void add(String sha256, Source source) throws IOException {
    Path file = path(sha256);
    Path work = Files.createTempFile(directory, "tmp", "");
    try {
      MessageDigest digest = Sha256.newDigest();
      try (OutputStream out = new DigestOutputStream(Files.newOutputStream(work), digest)) {
        source.writeTo(out);
      }
      String actual = Sha256.hex(digest);
      if (!actual.equals(sha256)) {
        throw new IOException("the file has the digest " + actual + ", expected " + sha256);
      }
      Files.move(work, file, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(work);
    }
  }

  private Path path(String sha256) {
    if (!SHA256.matcher(sha256).matches()) {
      throw new IllegalArgumentException(
          "'" + sha256 + "' is not a SHA-256 digest in lower-case hexadecimal");
    }
    return directory.resolve(sha256);
  }
}
