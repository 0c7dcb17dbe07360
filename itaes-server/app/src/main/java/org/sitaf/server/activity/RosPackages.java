package org.sitaf.server.activity;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.springframework.beans.factory.annotation.Value;
import org.springframework.stereotype.Component;

/** The interface packages of ROS 2 that activities can use without containing them. */
@Component
public final class RosPackages {
  private static final int MAX_DEPTH = 5;

  private final FileTree files;

  /**
   * @param folder holds {@code PACKAGE/msg/NAME.msg}; empty if there is none
   */
  RosPackages(@Value("${sitaf.ros-interfaces:}") String folder) {
    files = folder.isEmpty() ? FileTree.of(Map.of()) : load(Path.of(folder));
  }

  /** The interface files by {@code PACKAGE/msg/NAME.msg}. */
  public FileTree files() {
    return files;
  }

  /** Reads an activity, which may use these packages. */
  Activity read(FileTree activity) {
    return Activity.read(activity, files);
  }

  private static FileTree load(Path folder) {
    Map<String, byte[]> found = new HashMap<>();
    if (Files.isDirectory(folder)) {
      try (Stream<Path> all = Files.walk(folder, MAX_DEPTH)) {
        for (Path path : (Iterable<Path>) all.filter(Files::isRegularFile)::iterator) {
          found.put(folder.relativize(path).toString(), Files.readAllBytes(path));
        }
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return FileTree.of(found);
  }
}
