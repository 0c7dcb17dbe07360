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

/** The private folder of an agent; locked against use by a second agent. */
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
   * Opens the folder and creates it if it does not exist.
   *
   * @throws IOException if another agent uses it
   */
  public static AgentDirectory open(Path path) throws IOException {
    Path directory = path.toAbsolutePath().normalize();
    if (!Files.isDirectory(directory)) {
      Files.createDirectories(directory, PosixFilePermissions.asFileAttribute(PRIVATE));
    }
    restrictPermissions(directory);
    FileChannel file =
        FileChannel.open(
            directory.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    FileLock lock = tryLock(file);
    if (lock == null) {
      file.close();
      throw new IOException(
          directory + " is used by another agent; give each agent its own --directory");
    }
    return new AgentDirectory(directory, file, lock);
  }

  /** Restricts the permissions: the folder holds the agent's key and the files of users. */
  private static void restrictPermissions(Path directory) {
    try {
      if (!Files.getPosixFilePermissions(directory).equals(PRIVATE)) {
        Files.setPosixFilePermissions(directory, PRIVATE);
      }
    } catch (IOException e) {
      LOGGER.log(
          System.Logger.Level.WARNING,
          directory + " is readable by other users: " + e + "; please run: chmod 700 " + directory);
    }
  }

  private static @Nullable FileLock tryLock(FileChannel file) throws IOException {
    try {
      return file.tryLock();
    } catch (OverlappingFileLockException e) {
      return null;
    }
  }

  /** The absolute path. */
  public Path path() {
    return directory;
  }

  /** Results that the server has not accepted yet. */
  public Spool spool() throws IOException {
    return Spool.open(directory.resolve("spool"));
  }

  /** Files of test applications, by digest. */
  public FileCache fileCache() throws IOException {
    return FileCache.open(directory.resolve("files"));
  }

  /** Folders that are to be deleted. */
  public Trash trash() throws IOException {
    return Trash.open(directory.resolve("trash"));
  }

  /** The folders of builds; see {@link BuildFolders#open}. */
  public BuildFolders builds(Trash trash, String limitedFolder, int mebibytes, int files)
      throws IOException {
    return BuildFolders.open(directory.resolve("builds"), trash, limitedFolder, mebibytes, files);
  }

  @Override
  public void close() throws IOException {
    lock.release();
    lockFile.close();
  }
}
