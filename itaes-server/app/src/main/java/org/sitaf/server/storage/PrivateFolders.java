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
 * What the server stores is nobody else's to read: its folders are open to its own user only,
 * before anything is written there. Named in {@code META-INF/spring.factories}.
 */
final class PrivateFolders
    implements ApplicationContextInitializer<ConfigurableApplicationContext> {
  private static final Logger log = LoggerFactory.getLogger(PrivateFolders.class);
  private static final Set<PosixFilePermission> OWNERS_FOLDER =
      PosixFilePermissions.fromString("rwx------");
  private static final Set<PosixFilePermission> OWNERS =
      EnumSet.of(
          PosixFilePermission.OWNER_READ,
          PosixFilePermission.OWNER_WRITE,
          PosixFilePermission.OWNER_EXECUTE);

  /** What a server makes in its folder, and what {@code ./sitaf up} makes next to it. */
  private static final Set<String> OURS =
      Set.of("ports.properties", "logs", "uploads", "first-password", "server", "agent");

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
      log.warn("{}: this file system knows no permissions; keep others off it", folder);
      return;
    }
    if (isPrivate(folder)) {
      return;
    }
    Tightening tightening = new Tightening();
    if (!isOurs(folder)) {
      for (Path own : inside(folder, PrivateFolders::isOwn)) {
        Files.walkFileTree(own, tightening);
      }
      log.warn(
          "{} is open to other users of this machine and holds what is not the server's: give the"
              + " server a folder of its own",
          folder);
      return;
    }
    Files.walkFileTree(folder, tightening);
    log.warn(
        "{} was open to other users of this machine; it and the {} files and folders in it are the"
            + " server's own now",
        folder,
        tightening.changed);
  }

  /** Those above it as every program makes them, itself for its owner only. */
  private static void create(Path folder) throws IOException {
    if (folder.getParent() != null) {
      Files.createDirectories(folder.getParent());
    }
    try {
      Files.createDirectory(folder, PosixFilePermissions.asFileAttribute(OWNERS_FOLDER));
    } catch (UnsupportedOperationException e) {
      Files.createDirectory(folder);
    }
  }

  private static boolean isPrivate(Path path) throws IOException {
    return OWNERS.containsAll(Files.getPosixFilePermissions(path));
  }

  /** A folder above all others, or one that holds other things, too, is not ours to close. */
  private static boolean isOurs(Path folder) throws IOException {
    return folder.getFileName() != null
        && Files.getOwner(folder).getName().equals(System.getProperty("user.name"))
        && inside(folder, name -> !isOwn(name)).isEmpty();
  }

  private static boolean isOwn(String name) {
    return OURS.contains(name) || name.startsWith("database.") || name.endsWith(".log");
  }

  private static List<Path> inside(Path folder, Predicate<String> wanted) throws IOException {
    try (Stream<Path> inside = Files.list(folder)) {
      return inside.filter(path -> wanted.test(String.valueOf(path.getFileName()))).toList();
    }
  }

  private static final class Tightening extends SimpleFileVisitor<Path> {
    private int changed;

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes)
        throws IOException {
      return visitFile(folder, attributes);
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
      if (!attributes.isSymbolicLink() && !isPrivate(file)) {
        Set<PosixFilePermission> kept = EnumSet.copyOf(OWNERS);
        kept.retainAll(Files.getPosixFilePermissions(file));
        Files.setPosixFilePermissions(file, kept);
        changed++;
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      log.warn("{} cannot be closed to other users: {}", file, e.getMessage());
      return FileVisitResult.CONTINUE;
    }
  }
}
