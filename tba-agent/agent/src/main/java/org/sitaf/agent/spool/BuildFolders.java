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
 * A folder for each build. Where the agent may mount, what test applications write lies in a file
 * system in memory, of a size and a number of files that cannot be exceeded, and that vanishes as a
 * whole.
 */
public final class BuildFolders {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Path MOUNTS = Path.of("/proc/self/mountinfo");
  private static final int MOUNT_POINT = 4;
  private static final Duration MOUNTING = Duration.ofSeconds(10);

  private final Path directory;
  private final Trash trash;
  private final String bounded;
  private final String size;
  private volatile boolean mounts;

  private BuildFolders(Path directory, Trash trash, String bounded, String size, boolean mounts) {
    this.directory = directory;
    this.trash = trash;
    this.bounded = bounded;
    this.size = size;
    this.mounts = mounts;
  }

  /**
   * Opens it, and takes away what an agent before left there. Neither waits for a large tree nor
   * fails because of an odd one.
   *
   * @param bounded name of the folder in that of a build which test applications write to
   * @param mebibytes that it may hold, where the agent may mount
   * @param files that it may hold, likewise
   */
  static BuildFolders open(Path directory, Trash trash, String bounded, int mebibytes, int files)
      throws IOException {
    Files.createDirectories(directory);
    unmountAllBelow(directory);
    try (DirectoryStream<Path> left = Files.newDirectoryStream(directory)) {
      for (Path path : left) {
        trash.take(path);
      }
    } catch (DirectoryIteratorException e) {
      throw e.getCause();
    }
    boolean root = Integer.valueOf(0).equals(Files.getAttribute(Path.of("/proc/self"), "unix:uid"));
    String size = "size=" + mebibytes + "m,nr_inodes=" + files + ",mode=0755,nosuid,nodev";
    return new BuildFolders(directory, trash, bounded, size, root);
  }

  /** Where the folder of a build is, or would be. */
  public Path of(String build) {
    return directory.resolve(build);
  }

  /** Makes the folder of a build. */
  public Path begin(String build) throws IOException, InterruptedException {
    Path folder = Files.createDirectories(of(build));
    if (mounts) {
      Path inside = Files.createDirectories(folder.resolve(bounded));
      try {
        SystemTool.run(
            List.of("mount", "-t", "tmpfs", "-o", size, "sitaf", inside.toString()), MOUNTING);
      } catch (IOException e) {
        mounts = false;
        LOGGER.log(
            System.Logger.Level.INFO,
            "what components write lies on the disk, as this agent may not mount: "
                + e.getMessage());
      }
    }
    return folder;
  }

  /** Takes the folder of a build away; one that is not there is away already. */
  public void end(String build) throws IOException {
    Path folder = of(build);
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    boolean interrupted = Thread.interrupted();
    try {
      unmountAllBelow(folder);
      trash.take(folder);
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** At once, whether or not a file there is still open; it goes with the last of them. */
  private static void unmountAllBelow(Path folder) throws IOException {
    List<String> points = new ArrayList<>();
    if (!Files.isReadable(MOUNTS)) {
      return;
    }
    for (String line : Files.readAllLines(MOUNTS, StandardCharsets.ISO_8859_1)) {
      String point = unescaped(line.split(" ")[MOUNT_POINT]);
      if (point.startsWith(folder + "/")) {
        points.add(point);
      }
    }
    Collections.reverse(points);
    for (String point : points) {
      try {
        SystemTool.run(List.of("umount", "-l", "--", point), MOUNTING);
      } catch (IOException e) {
        LOGGER.log(System.Logger.Level.WARNING, point + " cannot be unmounted: " + e.getMessage());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  /** The kernel writes blanks and the like as octal numbers. */
  private static String unescaped(String path) {
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
