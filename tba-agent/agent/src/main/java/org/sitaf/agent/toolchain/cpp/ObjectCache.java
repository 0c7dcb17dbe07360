package org.sitaf.agent.toolchain.cpp;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/**
 * A cache of compiled translation units. An entry is found by the command and the unit's source,
 * and is valid only if the compiler would read the same files with the same content now, no matter
 * who added it. Several processes may use the cache: an entry is a single file, which appears by an
 * atomic rename and contains its own digest.
 *
 * @param folder private to the agent, with one folder per key
 */
record ObjectCache(Path folder) {
  private static final int FORMAT = 0x51_7a_f0_01;
  private static final int MOST_OF_A_KEY = 24;
  private static final LeastRecentlyUsed BOUNDS = new LeastRecentlyUsed(512L << 20, 5_000);

  /** Larger objects are not cached. */
  private static final long MOST_BYTES_OF_AN_ENTRY = 32L << 20;

  private static final int DIGEST_BYTES = 32;
  private static final String COMES = "new";
  private static final Duration ABANDONED = Duration.ofHours(1);

  /**
   * An entry.
   *
   * @param inputs all inputs that are not covered by the key
   * @param files by kind, such as {@code .o}
   */
  record Entry(Inputs inputs, Map<String, byte[]> files) {}

  /** The valid entry of a key, if any. */
  Optional<Entry> find(String key, InputCheck check) throws IOException {
    for (Path file : newestFirst(folder.resolve(key))) {
      try {
        byte[] bytes = Files.readAllBytes(file);
        Optional<Entry> entry = read(bytes, check);
        if (entry.isPresent()) {
          LeastRecentlyUsed.touch(file);
          return entry;
        }
      } catch (NoSuchFileException e) {
        // Another process has removed it.
      } catch (IOException e) {
        // The entry is damaged.
        Files.deleteIfExists(file);
      }
    }
    return Optional.empty();
  }

  /** Empty if the inputs have changed; throws if the file is damaged. */
  private static Optional<Entry> read(byte[] bytes, InputCheck check) throws IOException {
    int end = bytes.length - DIGEST_BYTES;
    if (end < 0) {
      throw new IOException("cut off");
    }
    DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes, 0, end));
    if (in.readInt() != FORMAT) {
      throw new IOException("of another format");
    }
    Inputs inputs = Inputs.read(in);
    if (!check.isCurrent(inputs)) {
      return Optional.empty();
    }
    if (!Arrays.equals(Digest.sha256(bytes, end), Arrays.copyOfRange(bytes, end, bytes.length))) {
      throw new IOException("changed");
    }
    Map<String, byte[]> files = new TreeMap<>();
    for (int i = in.readInt(); i > 0; i--) {
      files.put(in.readUTF(), in.readNBytes(in.readInt()));
    }
    return Optional.of(new Entry(inputs, files));
  }

  /** Adds an entry, unless its files are too large. */
  void keep(String key, Inputs inputs, Map<String, Path> files) throws IOException {
    long size = 0;
    for (Path file : files.values()) {
      size += Files.size(file);
    }
    if (size > MOST_BYTES_OF_AN_ENTRY) {
      return;
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeInt(FORMAT);
    inputs.write(out);
    Digest name = new Digest();
    name.add(bytes.toByteArray());
    out.writeInt(files.size());
    for (Map.Entry<String, Path> file : files.entrySet()) {
      byte[] content = Files.readAllBytes(file.getValue());
      out.writeUTF(file.getKey());
      out.writeInt(content.length);
      out.write(content);
    }
    out.write(Digest.sha256(bytes.toByteArray(), bytes.size()));
    createPrivate();
    Path fresh = Files.createTempFile(folder, COMES, ".part");
    Files.write(fresh, bytes.toByteArray());
    Path ofKey = folder.resolve(key);
    Path entry = ofKey.resolve(name.hexadecimal());
    try {
      Files.createDirectories(ofKey);
      Files.move(fresh, entry, StandardCopyOption.ATOMIC_MOVE);
    } catch (NoSuchFileException e) {
      // Another process has just removed the empty folder.
      Files.createDirectories(ofKey);
      Files.move(fresh, entry, StandardCopyOption.ATOMIC_MOVE);
    }
    List<Path> all = newestFirst(ofKey);
    for (Path old : all.subList(Math.min(MOST_OF_A_KEY, all.size()), all.size())) {
      Files.deleteIfExists(old);
    }
  }

  private void createPrivate() throws IOException {
    if (!Files.isDirectory(folder)) {
      Files.createDirectories(folder.getParent());
      Files.createDirectories(
          folder,
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    }
  }

  /** Removes the least recently used entries above the limits. */
  void shrink() throws IOException {
    List<Path> kept = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder, 2)) {
      for (Path file : files.filter(ObjectCache::isFile).toList()) {
        if (!file.getParent().equals(folder)) {
          kept.add(file);
        } else if (Files.getLastModifiedTime(file).toInstant().isBefore(abandoned())) {
          Files.deleteIfExists(file);
        }
      }
    } catch (NoSuchFileException | UncheckedIOException e) {
      // The cache is empty, or another process removes entries.
      return;
    }
    BOUNDS.shrink(
        kept,
        file -> file.toFile().length(),
        file -> {
          Files.deleteIfExists(file);
          deleteIfEmpty(file.getParent());
        });
  }

  private static Instant abandoned() {
    return Instant.now().minus(ABANDONED);
  }

  private static boolean isFile(Path file) {
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
  }

  private static void deleteIfEmpty(Path ofKey) throws IOException {
    try {
      Files.deleteIfExists(ofKey);
    } catch (DirectoryNotEmptyException e) {
      // The key has other entries.
    }
  }

  private static List<Path> newestFirst(Path folder) throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return LeastRecentlyUsed.newestFirst(all.toList());
    } catch (NoSuchFileException e) {
      return List.of();
    }
  }
}
