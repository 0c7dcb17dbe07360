package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * One folder per build. If the agent may mount, test applications write to a tmpfs of limited size
 * and number of files, which is removed as a whole.
 */
public final class BuildFolders {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Path MOUNTS = Path.of("/proc/self/mountinfo");
  private static final int MOUNT_POINT_FIELD = 4;
  private static final Duration MOUNT_TIMEOUT = Duration.ofSeconds(10);

  private final Path directory;
  private final Trash trash;
  private final String limitedFolder;
  private final String size;
  private volatile boolean mounts;

  private BuildFolders(
      Path directory, Trash trash, String limitedFolder, String size, boolean mounts) {
    this.directory = directory;
    this.trash = trash;
    this.limitedFolder = limitedFolder;
    this.size = size;
    this.mounts = mounts;
  }

  /**
   * Opens the folder and moves the folders of previous builds to the trash, which takes the same
   * time for trees of any size and shape.
   *
   * @param limitedFolder subfolder of a build's folder that test applications write to
   * @param mebibytes limit of its size if the agent may mount
   * @param files limit of its number of files, likewise
   */
  static BuildFolders open(
      Path directory, Trash trash, String limitedFolder, int mebibytes, int files)
      throws IOException {
    Files.createDirectories(directory);
    unmountAllBelow(directory);
    try (DirectoryStream<Path> previous = Files.newDirectoryStream(directory)) {
      for (Path path : previous) {
        trash.add(path);
      }
    } catch (DirectoryIteratorException e) {
      throw e.getCause();
    }
    boolean root = Integer.valueOf(0).equals(Files.getAttribute(Path.of("/proc/self"), "unix:uid"));
    String size = "size=" + mebibytes + "m,nr_inodes=" + files + ",mode=0755,nosuid,nodev";
    return new BuildFolders(directory, trash, limitedFolder, size, root);
  }

  /** The path of a build's folder, whether or not it exists. */
  public Path of(String build) {
    return directory.resolve(build);
  }

  /** Creates the folder of a build. */
  public Path create(String build) throws IOException, InterruptedException {
    Path folder = Files.createDirectories(of(build));
    if (mounts) {
      Path inside = Files.createDirectories(folder.resolve(limitedFolder));
      try {
        SystemTool.run(
            List.of("mount", "-t", "tmpfs", "-o", size, "sitaf", inside.toString()), MOUNT_TIMEOUT);
      } catch (IOException e) {
        mounts = false;
        LOGGER.log(
            System.Logger.Level.INFO,
            "test applications write to the disk, because this agent may not mount a tmpfs: "
                + e.getMessage());
      }
    }
    return folder;
  }

  /** Moves the folder of a build to the trash, if it exists. */
  public void remove(String build) throws IOException {
    Path folder = of(build);
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    boolean interrupted = Thread.interrupted();
    try {
      unmountAllBelow(folder);
      trash.add(folder);
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Detaches the mounts at once, even if files are open. */
  private static void unmountAllBelow(Path folder) throws IOException {
    List<String> points = new ArrayList<>();
    if (!Files.isReadable(MOUNTS)) {
      return;
    }
    for (String line : Files.readAllLines(MOUNTS, StandardCharsets.ISO_8859_1)) {
      String point = unescape(line.split(" ")[MOUNT_POINT_FIELD]);
      if (point.startsWith(folder + "/")) {
        points.add(point);
      }
    }
    Collections.reverse(points);
    for (String point : points) {
      try {
        SystemTool.run(List.of("umount", "-l", "--", point), MOUNT_TIMEOUT);
      } catch (IOException e) {
        LOGGER.log(System.Logger.Level.WARNING, point + " cannot be unmounted: " + e.getMessage());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  /** The kernel writes spaces and special characters as octal numbers. */
  private static String unescape(String path) {
    StringBuilder plain = new StringBuilder();
    for (int i = 0; i < path.length(); i++) {
      if (path.charAt(i) == '\\' && i + 3 < path.length()) {
        plain.append((char) Integer.parseInt(path.substring(i + 1, i + 4), 8));
        i += 3;
      } else {
        plain.append(path.charAt(i));
      }
    }
    byte[] bytes = plain.toString().getBytes(StandardCharsets.ISO_8859_1);
    return new String(bytes, StandardCharsets.UTF_8);
  }
}
