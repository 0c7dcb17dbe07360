package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** An agent's private folder; one agent at a time uses it. */
public final class AgentDirectory implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Set<PosixFilePermission> PRIVATE =
      PosixFilePermissions.fromString("rwx------");

  private final Path directory;
  private final FileChannel lockFile;
  private final FileLock lock;

  private AgentDirectory(Path directory, FileChannel lockFile, FileLock lock) {
    this.directory = directory;
    this.lockFile = lockFile;
    this.lock = lock;
  }

  /**
   * Opens the folder, and makes it where there is none.
   *
   * @throws IOException when another agent uses it
   */
  public static AgentDirectory open(Path path) throws IOException {
    Path directory = path.toAbsolutePath().normalize();
    if (!Files.isDirectory(directory)) {
      Files.createDirectories(directory, PosixFilePermissions.asFileAttribute(PRIVATE));
    }
    keepPrivate(directory);
    FileChannel file =
        FileChannel.open(
            directory.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    FileLock lock = tryLock(file);
    if (lock == null) {
      file.close();
      throw new IOException(
          directory + " is used by another agent; give each agent a --directory of its own");
    }
    return new AgentDirectory(directory, file, lock);
  }

  /** A key lies in it, and other people's files; somebody may have made it for all to read. */
  private static void keepPrivate(Path directory) {
    try {
      if (!Files.getPosixFilePermissions(directory).equals(PRIVATE)) {
        Files.setPosixFilePermissions(directory, PRIVATE);
      }
    } catch (IOException e) {
      LOGGER.log(
          System.Logger.Level.WARNING,
          directory + " can be read by others: " + e + "; please run: chmod 700 " + directory);
    }
  }

  private static @Nullable FileLock tryLock(FileChannel file) throws IOException {
    try {
      return file.tryLock();
    } catch (OverlappingFileLockException e) {
      return null;
    }
  }

  /** Absolute. */
  public Path path() {
    return directory;
  }

  /** Results that are owed to the server. */
  public Spool spool() throws IOException {
    return Spool.open(directory.resolve("spool"));
  }

  /** Files of test applications by their digest. */
  public FileCache fileCache() throws IOException {
    return FileCache.open(directory.resolve("files"));
  }

  /** Takes what is to be deleted. */
  public Trash trash() throws IOException {
    return Trash.open(directory.resolve("trash"));
  }

  /** The builds' own folders; see {@link BuildFolders#open}. */
  public BuildFolders builds(Trash trash, String bounded, int mebibytes, int files)
      throws IOException {
    return BuildFolders.open(directory.resolve("builds"), trash, bounded, mebibytes, files);
  }

  @Override
  public void close() throws IOException {
    lock.release();
    lockFile.close();
  }
}
