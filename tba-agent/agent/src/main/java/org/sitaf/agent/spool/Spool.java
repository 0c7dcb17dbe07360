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
 * Results on their way to the server. An entry is whole and on the disk when {@link #put} returns,
 * and stays until {@link #delete}: nothing is lost when the agent or the machine dies in between.
 * Entries appear and disappear by renaming their folder.
 */
public final class Spool {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-]{1,120}");
  private static final String IN_WORK = "tmp.";
  private static final String REJECTED = "rejected.";
  private static final String MESSAGE = "message";
  private static final String ATTACHMENTS = "attachments";

  private final Path directory;

  private Spool(Path directory) {
    this.directory = directory;
  }

  /** Opens a spool; what an earlier agent did not finish to write is removed. */
  static Spool open(Path directory) throws IOException {
    Files.createDirectories(directory);
    try (DirectoryStream<Path> unfinished = Files.newDirectoryStream(directory, IN_WORK + "*")) {
      for (Path path : unfinished) {
        Folders.delete(path);
      }
    }
    return new Spool(directory);
  }

  /** Something that the server shall have. */
  public record Entry(String name, Path directory) {
    /** What was put. */
    public byte[] message() throws IOException {
      return Files.readAllBytes(directory.resolve(MESSAGE));
    }

    /** The build's log; may be empty. */
    public Path log() {
      return directory.resolve("log");
    }

    /** What else goes with it, by its name. */
    public List<Path> attachments() throws IOException {
      return files(directory.resolve(ATTACHMENTS));
    }
  }

  /**
   * Puts an entry on the disk, and waits until it is there (fsync). One of the same name is
   * replaced.
   *
   * @param name letters, digits, '_' and '-'
   * @param log copied; null where there is none
   * @param attachments a folder whose files are copied; null where there is none
   */
  public synchronized Entry put(
      String name, byte[] message, @Nullable Path log, @Nullable Path attachments)
      throws IOException {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException("'" + name + "' is no name of a spool entry");
    }
    Path work = directory.resolve(IN_WORK + name);
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
    Path entry = directory.resolve(name);
    if (Files.exists(entry)) {
      delete(new Entry(name, entry));
    }
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
   * All entries, in the order of their names. What has no message is none, and is put aside: the
   * others must not wait for it.
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
          Path aside = reject(entry);
          LOGGER.log(
              System.Logger.Level.WARNING, name + " in the spool has no message; see " + aside);
        }
      }
    }
    entries.sort(java.util.Comparator.comparing(Entry::name));
    return entries;
  }

  /** Forgets an entry that the server has, or will never want. */
  public synchronized void delete(Entry entry) throws IOException {
    Path work = directory.resolve(IN_WORK + "deleted." + entry.name());
    Folders.delete(work);
    Files.move(entry.directory(), work, StandardCopyOption.ATOMIC_MOVE);
    Folders.delete(work);
  }

  /** Puts aside an entry that the server refuses, for a person to look at. */
  public synchronized Path reject(Entry entry) throws IOException {
    Path aside = directory.resolve(REJECTED + entry.name());
    Folders.delete(aside);
    return Files.move(entry.directory(), aside, StandardCopyOption.ATOMIC_MOVE);
  }

  private static void sync(Path path) throws IOException {
    try (FileChannel channel = FileChannel.open(path, StandardOpenOption.READ)) {
      channel.force(true);
    }
  }
}
