package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** Which files a confined process sees, each under its original path. */
final class MountPlan {
  /** Programs and libraries; symbolic links among them are kept. */
  private static final List<String> SYSTEM =
      List.of("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32");

  /**
   * System settings that programs read, such as library paths and the time zone, but nothing of
   * users.
   */
  private static final List<String> SETTINGS =
      List.of(
          "/etc/alternatives",
          "/etc/ld.so.cache",
          "/etc/ld.so.conf",
          "/etc/ld.so.conf.d",
          "/etc/localtime",
          "/etc/passwd",
          "/etc/group",
          "/etc/nsswitch.conf",
          "/etc/mime.types");

  /** Needed to connect to other machines. */
  private static final List<String> NETWORK =
      List.of(
          "/etc/resolv.conf",
          "/etc/hosts",
          "/etc/ssl",
          "/etc/ca-certificates",
          "/etc/pip.conf",
          "/etc/host.conf",
          "/etc/services");

  private static final Path TMP = Path.of("/tmp");

  /** Size of a tmpfs. */
  private static final String MEMORY_BYTES = Long.toString(64L << 20);

  private final List<String> arguments = new ArrayList<>();
  private final Set<Path> mountPoints = new TreeSet<>();
  private final Set<Path> created = new TreeSet<>();

  private MountPlan() {}

  /** The system alone. */
  static MountPlan system() throws IOException {
    MountPlan plan = new MountPlan();
    for (String folder : SYSTEM) {
      Path path = Path.of(folder);
      if (Files.isSymbolicLink(path)) {
        plan.add("--symlink", Files.readSymbolicLink(path).toString(), folder);
      } else if (Files.isDirectory(path)) {
        plan.add("--ro-bind", folder, folder);
        plan.mountPoints.add(path);
      }
    }
    plan.settings(SETTINGS);
    plan.javaSettings();
    plan.add("--proc", "/proc", "--dev", "/dev");
    return plan;
  }

  /** What a process sees. */
  static MountPlan of(Confinement confinement) throws IOException {
    MountPlan plan = system();
    if (confinement.network()) {
      plan.settings(NETWORK);
    }
    Map<Path, String> binds =
        new TreeMap<>(Comparator.comparing(Path::getNameCount).thenComparing(path -> path));
    for (Path path : confinement.readable()) {
      if (!isOfSystem(path)) {
        binds.put(path, "--ro-bind");
      }
    }
    for (Path path : confinement.writable()) {
      binds.put(path, "--bind");
    }
    binds.put(confinement.temporary(), "--bind");
    binds.put(confinement.working(), "--bind");
    plan.temporary(confinement, binds.keySet().stream().anyMatch(p -> p.startsWith(TMP)));
    // From the outside in, so that a writable folder may lie in a readable one.
    for (Map.Entry<Path, String> bind : binds.entrySet()) {
      Path path = bind.getKey();
      plan.makeParents(path);
      plan.add(bind.getValue(), path.toString(), path.toString());
      plan.mountPoints.add(path);
    }
    return plan;
  }

  /**
   * Mounts the default folders for temporary files. They are the process's own folder for temporary
   * files, whose bytes and number of files are limited; a tmpfs made by bubblewrap has no limit of
   * the number of files.
   *
   * @param tmpHoldsMountPoints whether {@code /tmp} needs a tmpfs, because bubblewrap must not
   *     create mount points in a folder that an earlier process could write
   */
  private void temporary(Confinement confinement, boolean tmpHoldsMountPoints) {
    String temporary = confinement.temporary().toString();
    if (tmpHoldsMountPoints) {
      add("--perms", "1777", "--size", MEMORY_BYTES, "--tmpfs", TMP.toString());
    } else {
      add("--bind", temporary, TMP.toString());
    }
    add("--bind", temporary, "/dev/shm");
    created.add(TMP);
  }

  /** Appends the arguments; folders that bubblewrap creates for mount points become read-only. */
  void appendTo(List<String> command) {
    command.addAll(arguments);
    command.addAll(List.of("--remount-ro", "/dev", "--remount-ro", "/"));
  }

  private void add(String... words) {
    arguments.addAll(List.of(words));
  }

  private void settings(List<String> files) {
    for (String file : files) {
      Path path = Path.of(file);
      if (Files.exists(path)) {
        makeParents(path);
        add("--ro-bind", file, file);
        mountPoints.add(path);
      }
    }
  }

  /** Debian keeps configuration files of JDKs and Python in one folder per version. */
  private void javaSettings() throws IOException {
    try (var folders = Files.newDirectoryStream(Path.of("/etc"), "{java,python3}*")) {
      List<String> names = new ArrayList<>();
      folders.forEach(folder -> names.add(folder.toString()));
      names.sort(null);
      settings(names);
    }
  }

  /** Creates the parent folders of a mount point, passable for the sandbox user. */
  private void makeParents(Path path) {
    List<Path> missing = new ArrayList<>();
    for (Path parent = path.getParent();
        parent != null
            && parent.getNameCount() > 0
            && mountPoints.stream().noneMatch(parent::startsWith);
        parent = parent.getParent()) {
      missing.add(0, parent);
    }
    for (Path parent : missing) {
      if (created.add(parent)) {
        add("--perms", "0755", "--dir", parent.toString());
      }
    }
  }

  private static boolean isOfSystem(Path path) {
    return SYSTEM.stream().anyMatch(folder -> path.startsWith(folder));
  }
}
