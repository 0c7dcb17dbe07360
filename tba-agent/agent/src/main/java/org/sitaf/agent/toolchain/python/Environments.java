package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileOwnerAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/**
 * Virtual environments, one for each set of packages, kept by their content. Each holds the runtime
 * of test applications, compiled; packages are fetched when an environment is made, and never while
 * a test runs. The agent writes into an environment before packages are installed, and not again.
 */
final class Environments {
  /** What the runtime needs, and what counts the lines that a component reaches. */
  private static final List<String> BASE =
      List.of("grpcio==1.85.1", "protobuf==7.36.2", "coverage==7.17.3");

  /** Changes with the way in which environments are made. */
  private static final String LAYOUT = "2";

  private static final int MOST_FILES = 300_000;

  private final Interpreter interpreter;
  private final Path runtime;
  private final SharedCache cache;
  private final PipSettings settings;

  /** One build makes an environment; others that want the same wait for it. */
  private final Map<String, Lock> inTheMaking = new ConcurrentHashMap<>();

  Environments(Interpreter interpreter, Path runtime, Path cache, PipSettings settings) {
    this.interpreter = interpreter;
    this.runtime = runtime;
    this.cache = new SharedCache(cache);
    this.settings = settings;
  }

  /** What compiles modules, without any package. */
  Path compiler() {
    return runtime.resolve("sitaf_runtime").resolve("compiling.py");
  }

  /** The interpreter of an environment. */
  static Path python(Path environment) {
    return environment.resolve("bin").resolve("python");
  }

  /** Whatever decides what an environment holds beside the component's packages. */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder();
    identity.append(LAYOUT).append(interpreter).append('\n').append(BASE).append('\n');
    for (Path file : files(runtime)) {
      identity
          .append(runtime.relativize(file))
          .append(' ')
          .append(digest(Files.readAllBytes(file)));
      identity.append('\n');
    }
    return identity.toString();
  }

  /**
   * The environment of these packages, made when it is asked for first.
   *
   * @throws CompilationException if pip cannot fetch or build what the component needs
   * @throws IOException if not even an environment without them can be made
   */
  Path with(Requirements requirements, Path scratch, Duration atMost, Sandbox sandbox)
      throws CompilationException, IOException, InterruptedException {
    StringBuilder held = new StringBuilder(identity());
    requirements.lines().forEach(line -> held.append('\n').append(line));
    for (Path wheel : requirements.wheels()) {
      held.append('\n')
          .append(wheel.getFileName())
          .append(' ')
          .append(digest(Files.readAllBytes(wheel)));
    }
    String key = digest(held.toString().getBytes(StandardCharsets.UTF_8));
    String name = key.substring(0, 24);
    if (Files.isDirectory(cache.entry(name))) {
      return cache.entry(name);
    }
    Lock lock = inTheMaking.computeIfAbsent(name, unused -> new ReentrantLock());
    lock.lockInterruptibly();
    try {
      if (!Files.isDirectory(cache.entry(name))) {
        PackageTools tools =
            new PackageTools(interpreter, settings, scratch, Instant.now().plus(atMost), sandbox);
        try (SharedCache.Draft draft = cache.draft()) {
          Path fresh = draft.folder();
          // Tests run as other users than the one that it is made by.
          Files.setPosixFilePermissions(fresh, PosixFilePermissions.fromString("rwxr-xr-x"));
          make(fresh, requirements, tools);
          own(fresh, requirements);
          draft.addAs(name);
        }
      }
      return cache.entry(name);
    } finally {
      lock.unlock();
      inTheMaking.remove(name);
    }
  }

  private void make(Path fresh, Requirements requirements, PackageTools tools)
      throws CompilationException, IOException, InterruptedException {
    ToolResult made = tools.venv(fresh);
    if (made.code() != 0) {
      throw new IOException("python -m venv: " + tools.complaint(made));
    }
    addRuntime(fresh, tools);
    Path known = baseWheels(fresh, tools);
    List<Path> wheels;
    try {
      // One request for both: what a component pins must fit to what the runtime needs.
      List<String> lines = new ArrayList<>(BASE);
      lines.addAll(requirements.lines());
      WheelCollection collection = new WheelCollection(tools, fresh, lines);
      for (Path wheel : requirements.wheels()) {
        collection.add(wheel);
      }
      wheels = requirements.isEmpty() ? LocalWheel.wheelsIn(known) : collection.collect(known);
    } catch (WheelCollection.PackageException e) {
      throw refused(requirements, String.valueOf(e.getMessage()));
    }
    ToolResult installed = SourceBuild.install(tools, fresh, wheels);
    if (installed.code() != 0) {
      String reason = tools.complaint(installed);
      if (requirements.isEmpty()) {
        throw new IOException("pip cannot install what test applications need: " + reason);
      }
      throw refused(requirements, reason);
    }
  }

  private static CompilationException refused(Requirements requirements, String reason) {
    return new CompilationException(
        "the component's packages cannot be installed",
        List.of(SourceDiagnostic.ofFile(requirements.file(), reason)));
  }

  private void addRuntime(Path fresh, PackageTools tools) throws IOException, InterruptedException {
    Path packages = fresh.resolve("lib").resolve("python" + minor()).resolve("site-packages");
    for (Path file : files(runtime)) {
      Path copy = packages.resolve(runtime.relativize(file).toString());
      Files.createDirectories(copy.getParent());
      Files.copy(file, copy);
    }
    ToolResult compiled =
        tools.module(fresh, "sitaf_runtime.compiling", packages.resolve("sitaf_runtime"), fresh);
    if (compiled.code() != 0) {
      throw new IOException("the runtime of Python tests cannot be compiled: " + compiled.output());
    }
  }

  /** What each environment holds, fetched once. */
  private Path baseWheels(Path fresh, PackageTools tools) throws IOException, InterruptedException {
    String name =
        "wheels-"
            + digest((LAYOUT + interpreter + BASE).getBytes(StandardCharsets.UTF_8))
                .substring(0, 24);
    Path known = cache.entry(name);
    if (!Files.isDirectory(known)) {
      Path folder = tools.folder();
      ToolResult fetched = new WheelCollection(tools, fresh, BASE).fetch(folder);
      if (fetched.code() != 0) {
        throw new IOException(
            "pip cannot fetch what test applications need: " + tools.complaint(fetched));
      }
      try (SharedCache.Draft draft = cache.draft()) {
        Files.setPosixFilePermissions(draft.folder(), PosixFilePermissions.fromString("rwxr-xr-x"));
        for (Path wheel : WheelCollection.wheels(folder)) {
          Files.copy(wheel, draft.folder().resolve(wheel.getFileName().toString()));
        }
        draft.addAs(name);
      }
    }
    return known;
  }

  private String minor() {
    return interpreter.version().substring(0, interpreter.version().lastIndexOf('.'));
  }

  /** Takes over what the tools have left, so that no later process owns it. */
  private void own(Path fresh, Requirements requirements) throws CompilationException, IOException {
    UserPrincipal owner = Files.getOwner(cache.directory());
    int count = 0;
    try (Stream<Path> paths = Files.walk(fresh)) {
      for (Path path : (Iterable<Path>) paths::iterator) {
        if (++count > MOST_FILES) {
          throw refused(requirements, "the packages hold more than " + MOST_FILES + " files");
        }
        if (!Files.getOwner(path, LinkOption.NOFOLLOW_LINKS).equals(owner)) {
          Files.getFileAttributeView(path, FileOwnerAttributeView.class, LinkOption.NOFOLLOW_LINKS)
              .setOwner(owner);
        }
      }
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      return new ArrayList<>(
          paths
              .filter(Files::isRegularFile)
              .filter(p -> p.toString().endsWith(".py"))
              .sorted()
              .toList());
    }
  }

  private static String digest(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }
}
