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
 * What was compiled of translation units, so that of a changed component only what changed is
 * compiled again. An entry is found by the command and the unit's own source, and counts only where
 * all that the compiler read then would be read now, with the same content; so it does not matter
 * whose build has added it. Several processes may use it at once: an entry is one file, which comes
 * by renaming and holds its own digest.
 *
 * @param folder of the agent alone, with a folder for each key
 */
record ObjectCache(Path folder) {
  private static final int FORMAT = 0x51_7a_f0_01;
  private static final int MOST_OF_A_KEY = 24;
  private static final LeastRecentlyUsed BOUNDS = new LeastRecentlyUsed(512L << 20, 5_000);

  /** What is larger is compiled each time. */
  private static final long MOST_BYTES_OF_AN_ENTRY = 32L << 20;

  private static final int DIGEST_BYTES = 32;
  private static final String COMES = "new";
  private static final Duration ABANDONED = Duration.ofHours(1);

  /**
   * An entry.
   *
   * @param inputs all that went into it, apart from what the key stands for
   * @param files by kind, such as {@code .o}
   */
  record Entry(Inputs inputs, Map<String, byte[]> files) {}

  /** The entry of a key whose inputs are those of now. */
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
        // Damaged: it is compiled as if it had never been there.
        Files.deleteIfExists(file);
      }
    }
    return Optional.empty();
  }

  /** Empty where something else was compiled; throws where it is not what was once written. */
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

  /** Adds an entry; files that are too large, or not there, are not kept. */
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

  /** Forgets what was not asked for the longest, where there is more than may be kept. */
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
      // Nothing is kept yet, or another process removes what is.
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
      // Something else of the key is kept.
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
