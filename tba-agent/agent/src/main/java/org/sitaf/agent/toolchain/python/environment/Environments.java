package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileOwnerAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.digest.Sha256;

/**
 * Virtual environments, cached by their set of packages. Each contains the compiled runtime of test
 * applications. Packages are downloaded when an environment is created, never during a test, and
 * unpacked once for all environments. Nothing writes into an environment that has packages.
 */
public final class Environments {
  /** Packages of the runtime, and the coverage tool. */
  private static final List<String> BASE =
      List.of("grpcio==1.85.1", "protobuf==7.36.2", "coverage==7.17.3");

  /** Increased when environments are created differently. */
  private static final String LAYOUT = "4";

  /** Increased when the packages of every environment are downloaded differently. */
  private static final String WHEELS = "2";

  /** Folder of the environment in an entry of the cache, next to the list of its packages. */
  private static final String ENVIRONMENT = "environment";

  /** Many environments, as far as their packages are the same. */
  private static final long MAX_BYTES = 4L << 30;

  private final Interpreter interpreter;
  private final Path runtime;
  private final SharedCache cache;
  private final KeptEnvironments kept;
  private final UnpackedWheels unpacked;
  private final PipSettings settings;

  /** One build creates an environment; other builds that need the same one wait. */
  private final Map<String, Lock> locks = new ConcurrentHashMap<>();

  public Environments(
      Interpreter interpreter, Path runtime, SharedCache cache, PipSettings settings) {
    this.interpreter = interpreter;
    this.runtime = runtime;
    this.cache = cache;
    this.kept = new KeptEnvironments(this.cache, MAX_BYTES, Clock.systemUTC());
    this.unpacked = new UnpackedWheels(this.cache, interpreter);
    this.settings = settings;
  }

  /** An environment without packages, used to compile modules. */
  public Path compiler() {
    return runtime.resolve("sitaf_runtime").resolve("compiling.py");
  }

  /** The interpreter of an environment. */
  public static Path python(Path environment) {
    return environment.resolve("bin").resolve("python");
  }

  /** Everything except the component's packages that determines the content of an environment. */
  public String identity() throws IOException {
    StringBuilder identity = new StringBuilder();
    identity.append(LAYOUT).append(interpreter).append('\n').append(BASE).append('\n');
    for (Path file : files(runtime)) {
      identity
          .append(runtime.relativize(file))
          .append(' ')
          .append(Sha256.hex(Files.readAllBytes(file)));
      identity.append('\n');
    }
    return identity.toString();
  }

  /**
   * The environment with these packages; creates it at the first use.
   *
   * @throws CompilationException if pip cannot download or build the component's packages
   * @throws IOException if the environment cannot be created even without them
   */
  public Path with(Requirements requirements, Path scratch, Duration atMost, Sandbox sandbox)
      throws CompilationException, IOException, InterruptedException {
    StringBuilder held = new StringBuilder(identity());
    requirements.lines().forEach(line -> held.append('\n').append(line));
    for (Path wheel : requirements.wheels()) {
      held.append('\n')
          .append(wheel.getFileName())
          .append(' ')
          .append(Sha256.hex(Files.readAllBytes(wheel)));
    }
    ActivityLock releases = requirements.lock();
    if (releases != null) {
      held.append('\n').append(releases.text());
    }
    String key = Sha256.hex(held.toString().getBytes(StandardCharsets.UTF_8));
    String name = key.substring(0, 24);
    Optional<Path> existing = cache.existing(name);
    if (existing.isPresent()) {
      KeptEnvironments.use(existing.get());
      return existing.get().resolve(ENVIRONMENT);
    }
    Lock lock = locks.computeIfAbsent(name, unused -> new ReentrantLock());
    lock.lockInterruptibly();
    try {
      if (!Files.isDirectory(cache.entry(name))) {
        PackageTools tools =
            new PackageTools(
                interpreter, settings, scratch, atMost, Instant.now().plus(atMost), sandbox);
        try (SharedCache.Draft draft = cache.draft()) {
          Path fresh = folderIn(draft);
          List<ResolvedPackage> packages = create(fresh, requirements, tools);
          EnvironmentPackages.write(draft.folder(), packages);
          KeptEnvironments.measure(draft.folder());
          draft.addAs(name);
        }
        kept.shrink();
      }
      return cache.entry(name).resolve(ENVIRONMENT);
    } finally {
      lock.unlock();
      locks.remove(name);
    }
  }

  /** The packages of the component in an environment, in ascending order. */
  public List<ResolvedPackage> packages(Path environment) throws IOException {
    return EnvironmentPackages.read(environment.getParent());
  }

  /** The folder of a new environment. */
  private static Path folderIn(SharedCache.Draft draft) throws IOException {
    makeReadable(draft.folder());
    Path fresh = Files.createDirectory(draft.folder().resolve(ENVIRONMENT));
    makeReadable(fresh);
    return fresh;
  }

  /** Tests run as other users than the one that creates the environment. */
  static void makeReadable(Path folder) throws IOException {
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  /** Creates an environment and returns the packages of the component. */
  private List<ResolvedPackage> create(Path fresh, Requirements requirements, PackageTools tools)
      throws CompilationException, IOException, InterruptedException {
    ToolResult made = tools.emptyVenv(fresh);
    if (made.code() != 0) {
      throw new IOException("python -m venv: " + tools.errorOf(made));
    }
    addRuntime(fresh, tools);
    // No process can write into it any more: what is added now is shared with other environments.
    takeOwnership(fresh, cache);
    Path pip = pip(tools);
    Path known = baseWheels(pip, tools);
    try {
      // One request, because the component's packages must be compatible with those of the runtime.
      List<String> lines = new ArrayList<>(BASE);
      lines.addAll(requirements.lines());
      WheelCollection collection = new WheelCollection(tools, pip, lines, requirements.lock());
      for (Path wheel : requirements.wheels()) {
        collection.add(wheel);
      }
      List<Path> wheels =
          requirements.isEmpty() ? LocalWheel.wheelsIn(known) : collection.collect(known);
      List<ResolvedPackage> resolved = collection.resolved(wheels);
      List<ResolvedPackage> packages =
          resolved.stream().filter(Environments::isOfComponent).toList();
      requireLocked(requirements, packages);
      for (Path tree : unpacked.of(wheels, pip, tools)) {
        UnpackedWheels.link(tree, fresh);
      }
      new PythonsOwnPackages(sitePackages(pip)).link(sitePackages(fresh), names(resolved));
      return packages;
    } catch (WheelCollection.PackageException e) {
      if (requirements.isEmpty()) {
        throw new IOException("what test applications need cannot be installed: " + e.getMessage());
      }
      throw failure(requirements, String.valueOf(e.getMessage()));
    }
  }

  private static Set<String> names(List<ResolvedPackage> packages) {
    return packages.stream().map(ResolvedPackage::name).collect(Collectors.toSet());
  }

  private static void requireLocked(Requirements requirements, List<ResolvedPackage> packages)
      throws CompilationException {
    ActivityLock lock = requirements.lock();
    String mismatch = lock == null ? null : lock.mismatch(packages).orElse(null);
    if (mismatch != null) {
      throw new CompilationException(
          "the component's packages are not those of " + ActivityLock.FILE,
          List.of(SourceDiagnostic.ofFile("activity/" + ActivityLock.FILE, mismatch)));
    }
  }

  /** Not one of the runtime's packages, whose releases belong to the release of the agent. */
  private static boolean isOfComponent(ResolvedPackage resolved) {
    return BASE.stream().noneMatch(line -> line.startsWith(resolved.name() + "=="));
  }

  private static CompilationException failure(Requirements requirements, String reason) {
    return new CompilationException(
        "the component's packages cannot be installed",
        List.of(SourceDiagnostic.ofFile(requirements.file(), reason)));
  }

  private void addRuntime(Path fresh, PackageTools tools) throws IOException, InterruptedException {
    Path packages = sitePackages(fresh);
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

  /** The packages of every environment, downloaded once. */
  private Path baseWheels(Path pip, PackageTools tools) throws IOException, InterruptedException {
    String name =
        "wheels-"
            + Sha256.hex((WHEELS + interpreter + BASE).getBytes(StandardCharsets.UTF_8))
                .substring(0, 24);
    if (cache.existing(name).isEmpty()) {
      Path folder = tools.folder();
      ToolResult fetched = new WheelCollection(tools, pip, BASE, null).fetch(folder);
      if (fetched.code() != 0) {
        throw new IOException(
            "pip cannot download what test applications need: " + tools.errorOf(fetched));
      }
      try (SharedCache.Draft draft = cache.draft()) {
        makeReadable(draft.folder());
        for (Path wheel : WheelCollection.wheels(folder)) {
          Files.copy(wheel, draft.folder().resolve(wheel.getFileName().toString()));
        }
        draft.addAs(name);
      }
    }
    return cache.existing(name).orElseThrow();
  }

  /** The environment whose pip downloads and unpacks; created once. */
  private Path pip(PackageTools tools) throws IOException, InterruptedException {
    String key = LAYOUT + interpreter;
    String name = "pip-" + Sha256.hex(key.getBytes(StandardCharsets.UTF_8)).substring(0, 24);
    if (cache.existing(name).isEmpty()) {
      try (SharedCache.Draft draft = cache.draft()) {
        Path fresh = folderIn(draft);
        ToolResult made = tools.venv(fresh);
        if (made.code() != 0) {
          throw new IOException("python -m venv: " + tools.errorOf(made));
        }
        takeOwnership(fresh, cache);
        draft.addAs(name);
      }
    }
    return cache.existing(name).orElseThrow().resolve(ENVIRONMENT);
  }

  private Path sitePackages(Path environment) {
    String minor = interpreter.version().substring(0, interpreter.version().lastIndexOf('.'));
    return environment.resolve("lib").resolve("python" + minor).resolve("site-packages");
  }

  /** Takes ownership of the files, so that no later process can change them. */
  static void takeOwnership(Path folder, SharedCache cache) throws IOException {
    UserPrincipal owner = Files.getOwner(cache.directory());
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path path : (Iterable<Path>) paths::iterator) {
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
}
