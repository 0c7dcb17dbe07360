package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Results that wait for the upload to the server. When {@link #put} returns, an entry is complete
 * and on disk, and stays there until {@link #delete}, even if the agent or the machine crashes.
 * Entries appear and disappear by an atomic rename.
 */
public final class Spool {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-]{1,120}");
  private static final String TEMPORARY = "tmp.";
  private static final String REJECTED = "rejected.";
  private static final String MESSAGE = "message";
  private static final String ATTACHMENTS = "attachments";

  private final Path directory;

  private Spool(Path directory) {
    this.directory = directory;
  }

  /** Opens a spool and removes incomplete entries of a previous agent. */
  static Spool open(Path directory) throws IOException {
    Files.createDirectories(directory);
    try (DirectoryStream<Path> unfinished = Files.newDirectoryStream(directory, TEMPORARY + "*")) {
      for (Path path : unfinished) {
        Folders.delete(path);
      }
    }
    return new Spool(directory);
  }

  /** A result for the server. */
  public record Entry(String name, Path directory) {
    /** The message as it was put. */
    public byte[] message() throws IOException {
      return Files.readAllBytes(directory.resolve(MESSAGE));
    }

    /** The build log; may be empty. */
    public Path log() {
      return directory.resolve("log");
    }

    /** Attached files, sorted by name. */
    public List<Path> attachments() throws IOException {
      return files(directory.resolve(ATTACHMENTS));
    }
  }

  /**
   * Writes an entry and waits until it is on disk (fsync). Replaces an entry of the same name.
   *
   * @param name letters, digits, '_' and '-'
   * @param log copied; null for none
   * @param attachments folder whose files are copied; null for none
   */
  public synchronized Entry put(
      String name, byte[] message, @Nullable Path log, @Nullable Path attachments)
      throws IOException {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException("'" + name + "' is not a valid name of a spool entry");
    }
    Path work = write(name, message, log, attachments);
    Path entry = directory.resolve(name);
    if (Files.exists(entry)) {
      delete(new Entry(name, entry));
    }
    return publish(work, name);
  }

  /**
   * Sets an entry aside, as {@link #reject} does, and another message with the same log in its
   * place. When the message cannot be written, the entry stays as it is.
   */
  public synchronized Entry replace(Entry entry, byte[] message) throws IOException {
    Path work = write(entry.name(), message, entry.log(), null);
    reject(entry);
    return publish(work, entry.name());
  }

  private Path write(String name, byte[] message, @Nullable Path log, @Nullable Path attachments)
      throws IOException {
    Path work = directory.resolve(TEMPORARY + name);
    Folders.delete(work);
    Files.createDirectories(work);
    Files.write(work.resolve(MESSAGE), message);
    if (log != null && Files.isRegularFile(log)) {
      Files.copy(log, work.resolve("log"));
    } else {
      Files.write(work.resolve("log"), new byte[0]);
    }
    if (attachments != null) {
      attach(attachments, Files.createDirectory(work.resolve(ATTACHMENTS)));
    }
    sync(work.resolve(MESSAGE));
    sync(work.resolve("log"));
    sync(work);
    return work;
  }

  private Entry publish(Path work, String name) throws IOException {
    Path entry = directory.resolve(name);
    Files.move(work, entry, StandardCopyOption.ATOMIC_MOVE);
    sync(directory);
    return new Entry(name, entry);
  }

  private static void attach(Path from, Path to) throws IOException {
    for (Path file : files(from)) {
      sync(Files.copy(file, to.resolve(file.getFileName())));
    }
    sync(to);
  }

  private static List<Path> files(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  /**
   * All entries, sorted by name. An invalid entry without a message is set aside, so that it does
   * not block the others.
   */
  public synchronized List<Entry> entries() throws IOException {
    List<Entry> entries = new ArrayList<>();
    try (DirectoryStream<Path> folders = Files.newDirectoryStream(directory)) {
      for (Path folder : folders) {
        String name = folder.getFileName().toString();
        if (!NAME.matcher(name).matches()) {
          continue;
        }
        Entry entry = new Entry(name, folder);
        if (Files.isRegularFile(folder.resolve(MESSAGE), LinkOption.NOFOLLOW_LINKS)) {
          entries.add(entry);
        } else {
          Path rejected = reject(entry);
          LOGGER.log(
              System.Logger.Level.WARNING, name + " in the spool has no message; see " + rejected);
        }
      }
    }
    entries.sort(java.util.Comparator.comparing(Entry::name));
    return entries;
  }

  /** Deletes an entry that the server has accepted or will never accept. */
  public synchronized void delete(Entry entry) throws IOException {
    Path work = directory.resolve(TEMPORARY + "deleted." + entry.name());
    Folders.delete(work);
    Files.move(entry.directory(), work, StandardCopyOption.ATOMIC_MOVE);
    Folders.delete(work);
  }

  /** Sets aside an entry that the server rejected, for inspection by the administrator. */
  public synchronized Path reject(Entry entry) throws IOException {
    Path rejected = directory.resolve(REJECTED + entry.name());
    for (int i = 2; Files.exists(rejected, LinkOption.NOFOLLOW_LINKS); i++) {
      rejected = directory.resolve(REJECTED + entry.name() + "." + i);
    }
    return Files.move(entry.directory(), rejected, StandardCopyOption.ATOMIC_MOVE);
  }

  private static void sync(Path path) throws IOException {
    try (FileChannel channel = FileChannel.open(path, StandardOpenOption.READ)) {
      channel.force(true);
    }
  }
}
