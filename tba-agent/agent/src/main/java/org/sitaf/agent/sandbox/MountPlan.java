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

/** Which files a confined process sees, each under the path that it has outside. */
final class MountPlan {
  /** Where programs and libraries are; links among them stay links. */
  private static final List<String> SYSTEM =
      List.of("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32");

  /**
   * What programs read of the system's settings: how libraries are found, what the time zone is.
   * Not what belongs to users.
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

  /** What reaching other machines takes. */
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

  /** Of each file system in memory. */
  private static final String MEMORY_BYTES = Long.toString(64L << 20);

  private final List<String> arguments = new ArrayList<>();
  private final Set<Path> mounted = new TreeSet<>();
  private final Set<Path> passed = new TreeSet<>();

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
        plan.mounted.add(path);
      }
    }
    plan.settings(SETTINGS);
    plan.javaSettings();
    plan.add("--proc", "/proc", "--dev", "/dev");
    return plan;
  }

  /**
   * What a process sees.
   *
   * @param memoryIsCounted whether a control group counts what is in file systems in memory, files
   *     without content among it; else there is none that can be written
   */
  static MountPlan of(Confinement confinement, boolean memoryIsCounted) throws IOException {
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
    plan.temporary(
        confinement, memoryIsCounted || binds.keySet().stream().anyMatch(p -> p.startsWith(TMP)));
    // From the outside in, so that a writable folder may lie in a readable one.
    for (Map.Entry<Path, String> bind : binds.entrySet()) {
      Path path = bind.getKey();
      plan.makeParents(path);
      plan.add(bind.getValue(), path.toString(), path.toString());
      plan.mounted.add(path);
    }
    return plan;
  }

  /** Where programs write by default. */
  private void temporary(Confinement confinement, boolean inMemory) {
    for (String folder : List.of(TMP.toString(), "/dev/shm")) {
      if (inMemory) {
        add("--perms", "1777", "--size", MEMORY_BYTES, "--tmpfs", folder);
      } else {
        add("--bind", confinement.temporary().toString(), folder);
      }
    }
    passed.add(TMP);
  }

  /** What bubblewrap makes in memory for the mounts is not to be written. */
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
        mounted.add(path);
      }
    }
  }

  /** Debian's JDKs keep parts of themselves in /etc, one folder a version. */
  private void javaSettings() throws IOException {
    try (var folders = Files.newDirectoryStream(Path.of("/etc"), "{java,python3}*")) {
      List<String> names = new ArrayList<>();
      folders.forEach(folder -> names.add(folder.toString()));
      names.sort(null);
      settings(names);
    }
  }

  /** Folders on the way that nobody mounts; another user than the agent's must pass them. */
  private void makeParents(Path path) {
    List<Path> missing = new ArrayList<>();
    for (Path parent = path.getParent();
        parent != null
            && parent.getNameCount() > 0
            && mounted.stream().noneMatch(parent::startsWith);
        parent = parent.getParent()) {
      missing.add(0, parent);
    }
    for (Path parent : missing) {
      if (passed.add(parent)) {
        add("--perms", "0755", "--dir", parent.toString());
      }
    }
  }

  private static boolean isOfSystem(Path path) {
    return SYSTEM.stream().anyMatch(folder -> path.startsWith(folder));
  }
}
