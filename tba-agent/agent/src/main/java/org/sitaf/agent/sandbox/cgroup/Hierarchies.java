package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The control groups of this process ({@code /proc/self/cgroup}) and where they are mounted ({@code
 * /proc/self/mountinfo}).
 *
 * @param unified folder of this process in the version 2 hierarchy
 * @param controllers folder of this process for each controller of version 1
 */
record Hierarchies(Optional<Path> unified, Map<String, Path> controllers) {
  private static final int ROOT_FIELD = 3;
  private static final int POINT_FIELD = 4;

  Hierarchies {
    controllers = Map.copyOf(controllers);
  }

  static Hierarchies ofThisProcess() throws IOException {
    return of(
        Files.readAllLines(Path.of("/proc/self/cgroup")),
        Files.readAllLines(Path.of("/proc/self/mountinfo")));
  }

  static Hierarchies of(List<String> memberships, List<String> mounts) {
    Map<String, Path> found = new HashMap<>();
    Path unified = null;
    for (String membership : memberships) {
      // NUMBER:CONTROLLERS:PATH
      String[] parts = membership.split(":", 3);
      if (parts.length < 3) {
        continue;
      }
      for (String controller : parts[1].split(",")) {
        Optional<Path> folder = folder(controller, parts[2], mounts);
        if (folder.isPresent() && controller.isEmpty()) {
          unified = folder.get();
        } else if (folder.isPresent()) {
          found.put(controller, folder.get());
        }
      }
    }
    return new Hierarchies(Optional.ofNullable(unified), found);
  }

  private static Optional<Path> folder(String controller, String own, List<String> mounts) {
    for (String mount : mounts) {
      String[] halves = mount.split(" - ", 2);
      String[] fields = halves[0].split(" ");
      if (halves.length < 2 || fields.length <= POINT_FIELD) {
        continue;
      }
      String[] system = halves[1].split(" ");
      boolean wanted =
          controller.isEmpty()
              ? system[0].equals("cgroup2")
              : system[0].equals("cgroup")
                  && Arrays.asList(system[system.length - 1].split(",")).contains(controller);
      Path root = Path.of(fields[ROOT_FIELD]);
      if (wanted && Path.of(own).startsWith(root)) {
        return Optional.of(
            Path.of(fields[POINT_FIELD]).resolve(root.relativize(Path.of(own)).toString()));
      }
    }
    return Optional.empty();
  }

  /** Those of the given version 1 controllers whose folder this process may write. */
  List<String> writable(List<String> names) {
    List<String> writable = new ArrayList<>();
    for (String name : names) {
      Path folder = controllers.get(name);
      if (folder != null && isWritable(folder)) {
        writable.add(name);
      }
    }
    return writable;
  }

  static boolean isWritable(Path folder) {
    return Files.isWritable(folder) && Files.isWritable(folder.resolve(ControlGroup.MEMBERS));
  }
}
