package org.sitaf.server.storage;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.ApplicationContextInitializer;
import org.springframework.context.ConfigurableApplicationContext;
import org.springframework.core.env.Environment;

/**
 * Restricts the server's folders to its own user before anything is written there. Registered in
 * {@code META-INF/spring.factories}.
 */
final class FolderPermissions
    implements ApplicationContextInitializer<ConfigurableApplicationContext> {
  private static final Logger log = LoggerFactory.getLogger(FolderPermissions.class);
  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rwx------");
  private static final Set<PosixFilePermission> OWNER_PERMISSIONS =
      EnumSet.of(
          PosixFilePermission.OWNER_READ,
          PosixFilePermission.OWNER_WRITE,
          PosixFilePermission.OWNER_EXECUTE);

  /** Files of the server, and folders that {@code ./sitaf up} creates next to them. */
  private static final Set<String> OWN_NAMES =
      Set.of(
          "ports.properties",
          "logs",
          "uploads",
          "first-password",
          "server",
          "agent",
          "git",
          "git.key");

  @Override
  public void initialize(ConfigurableApplicationContext context) {
    Environment environment = context.getEnvironment();
    String data = environment.getProperty("sitaf.data-directory");
    try {
      if (data != null) {
        secure(Path.of(data).toAbsolutePath().normalize());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static void secure(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      create(folder);
      return;
    }
    if (!Files.getFileStore(folder).supportsFileAttributeView("posix")) {
      log.warn(
          "{}: the file system has no permissions; make sure that other users cannot read it",
          folder);
      return;
    }
    if (isPrivate(folder)) {
      return;
    }
    PermissionRestrictor restrictor = new PermissionRestrictor();
    if (!isServersFolder(folder)) {
      for (Path own : children(folder, FolderPermissions::isOwn)) {
        Files.walkFileTree(own, restrictor);
      }
      log.warn(
          "{} is accessible to other users and contains files that are not the server's: use a"
              + " separate folder for the server",
          folder);
      return;
    }
    Files.walkFileTree(folder, restrictor);
    log.warn(
        "{} was accessible to other users; it and {} files and folders in it are now restricted to"
            + " the server's user",
        folder,
        restrictor.changed);
  }

  /**
   * Creates the folder with restricted permissions, and missing parents with default permissions.
   */
  private static void create(Path folder) throws IOException {
    if (folder.getParent() != null) {
      Files.createDirectories(folder.getParent());
    }
    try {
      Files.createDirectory(folder, PosixFilePermissions.asFileAttribute(OWNER_ONLY));
    } catch (UnsupportedOperationException e) {
      Files.createDirectory(folder);
    }
  }

  private static boolean isPrivate(Path path) throws IOException {
    return OWNER_PERMISSIONS.containsAll(Files.getPosixFilePermissions(path));
  }

  /**
   * Whether the folder contains nothing but the server's files, so that it can be restricted as a
   * whole.
   */
  private static boolean isServersFolder(Path folder) throws IOException {
    return folder.getFileName() != null
        && Files.getOwner(folder).getName().equals(System.getProperty("user.name"))
        && children(folder, name -> !isOwn(name)).isEmpty();
  }

  private static boolean isOwn(String name) {
    return OWN_NAMES.contains(name) || name.startsWith("database.") || name.endsWith(".log");
  }

  private static List<Path> children(Path folder, Predicate<String> filter) throws IOException {
    try (Stream<Path> children = Files.list(folder)) {
      return children.filter(path -> filter.test(String.valueOf(path.getFileName()))).toList();
    }
  }

  private static final class PermissionRestrictor extends SimpleFileVisitor<Path> {
    private int changed;

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes)
        throws IOException {
      return visitFile(folder, attributes);
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
      if (!attributes.isSymbolicLink() && !isPrivate(file)) {
        Set<PosixFilePermission> restricted = EnumSet.copyOf(OWNER_PERMISSIONS);
        restricted.retainAll(Files.getPosixFilePermissions(file));
        Files.setPosixFilePermissions(file, restricted);
        changed++;
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      log.warn("Permissions of {} cannot be restricted: {}", file, e.getMessage());
      return FileVisitResult.CONTINUE;
    }
  }
}
