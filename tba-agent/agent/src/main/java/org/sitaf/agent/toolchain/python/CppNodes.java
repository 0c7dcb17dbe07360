package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.OneTimeCompilation;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.cpp.Tools;
import org.sitaf.agent.toolchain.python.environment.Environments;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.harness.ros.RosHarness;

/**
 * Compiles C++ ROS 2 nodes to a library that the Python test application loads. The runtime of
 * nodes is compiled once per compiler and set of interface files that it uses.
 */
final class CppNodes {
  private static final String BUILD = "sitaf_ros.cpp.build";
  private static final String SOURCES = "component";

  /** Prefix of the activity's paths in what the compiler records. */
  static final String ACTIVITY = "activity/";

  private static final String NOTES = "coverage";

  /** For the runtime, which has no code of users and may meet a busy machine. */
  private static final Duration RUNTIME_AT_MOST = Duration.ofMinutes(20);

  private final Path api;
  private final SharedCache cache;
  private final Lock lock = new ReentrantLock();

  /**
   * @param api sources of the runtime of nodes
   * @param cache folder for compiled runtimes, shared with other agents and commands
   */
  CppNodes(Path api, Path cache) {
    this.api = api;
    this.cache = new SharedCache(cache);
  }

  /** What determines the result of {@link #compile} besides the sources. */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder("\n");
    Optional<Path> compiler = compiler();
    if (compiler.isPresent()) {
      Path program = compiler.get().toRealPath();
      identity.append(program).append(' ').append(Files.size(program)).append(' ');
      identity.append(Files.getLastModifiedTime(program)).append('\n');
    }
    if (Files.isDirectory(api)) {
      try (Stream<Path> files = Files.walk(api)) {
        for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
          identity.append(api.relativize(file)).append(' ');
          identity.append(Sha256.hex(Files.readAllBytes(file))).append('\n');
        }
      }
    }
    return identity.toString();
  }

  private static Optional<Path> compiler() {
    String chosen = System.getenv("CXX");
    return chosen == null || chosen.isBlank()
        ? Tools.find("g++", "clang++")
        : Tools.find(chosen.strip());
  }

  /**
   * Compiles a node into the folder of the harness.
   *
   * @param environment has the runtime of test applications, and no packages of the component,
   *     which could change the runtime that builds share
   * @param prefixes folders of Python's own library
   * @param roots names of the copies of the activity's folders in the output folder
   * @param ros the installation that the node runs with; null for the runtime that comes along
   */
  void compile(
      Compilation compilation,
      Path environment,
      List<Path> prefixes,
      Map<String, String> roots,
      @Nullable RosInstallation ros)
      throws CompilationException, IOException, InterruptedException {
    Path compiler =
        compiler()
            .orElseThrow(
                () ->
                    new CompilationException(
                        "a ROS 2 node in C++ needs a C++ compiler; ./sitaf doctor --install cpp",
                        List.of()));
    ActivityProfile profile = compilation.application().activity().profile();
    RosNode node = Objects.requireNonNull(profile.ros());
    Path harness = compilation.output().resolve("harness");
    Path interfaces = harness.resolve(RosHarness.INTERFACES);
    List<Path> readable = new ArrayList<>(prefixes);
    readable.addAll(List.of(environment, api, harness));
    Path into = folder(compilation);
    Files.createDirectories(into);
    Path scratch = Files.createTempDirectory(compilation.scratch(), "node-");
    Path sources = compilation.output().resolve(SOURCES);
    List<String> arguments = new ArrayList<>(List.of("node", "--compiler", compiler.toString()));
    add(arguments, "--api", api);
    add(arguments, "--interfaces", interfaces);
    add(arguments, "--into", into);
    add(arguments, "--scratch", scratch);
    add(arguments, "--package", sources);
    arguments.addAll(List.of("--entry", node.entry()));
    if (node.isMain()) {
      arguments.add("--main");
    }
    if (!node.packages().isEmpty()) {
      arguments.add("--packages");
      arguments.addAll(node.packages());
    }
    String inActivity = ACTIVITY + profile.component().sources();
    arguments.addAll(List.of("--recorded-as", inActivity.replaceAll("/+$", "")));
    if (compilation.coverage()) {
      arguments.add("--coverage");
    }
    if (!profile.sanitizers().isEmpty()) {
      arguments.add("--sanitize");
      profile.sanitizers().forEach(sanitizer -> arguments.add(sanitizer.id()));
    }
    if (ros == null) {
      Path runtime = runtime(compilation, environment, compiler, interfaces, List.copyOf(readable));
      add(arguments, "--runtime", runtime);
      readable.add(runtime);
    } else {
      arguments.add("--ros");
      ros.prefixes().forEach(prefix -> arguments.add(prefix.toString()));
      readable.addAll(ros.readable());
    }
    readable.add(sources);
    ToolResult end =
        run(
            compilation,
            environment,
            arguments,
            scratch,
            readable,
            List.of(into),
            compilation.atMost());
    if (end.timedOut()) {
      throw new CompilationException(
          "the compilation did not finish within " + compilation.atMost().toSeconds() + " s",
          List.of());
    }
    List<SourceDiagnostic> mistakes =
        end.code() == 0
            ? List.of()
            : end.output()
                .lines()
                .map(line -> PythonToolchain.diagnostic(line, compilation.output(), roots))
                .toList();
    if (!mistakes.isEmpty()) {
      throw new CompilationException("the node does not compile: " + mistakes.get(0), mistakes);
    }
    if (end.code() != 0) {
      throw new IOException(
          "the build of the node ended with exit code " + end.code() + ": " + end.errors());
    }
  }

  /** The folder of the compiled node. */
  private static Path folder(Compilation compilation) {
    Path library = compilation.output().resolve("harness").resolve(RosHarness.LIBRARY);
    return Objects.requireNonNull(library.getParent());
  }

  /**
   * How a compiled node records its lines; null if gcov is not installed, or cannot read what the
   * compiler writes.
   *
   * @param sources folder of the node's sources in the activity, with a trailing slash
   */
  static @Nullable Recording recording(Compilation compilation, String sources) {
    Path notes = folder(compilation).resolve(NOTES);
    return Files.isDirectory(notes) && Tools.find("gcov").isPresent()
        ? new NodeCoverage(
            notes, compilation.scratch().resolve("coverage"), compilation.sandbox(), sources)
        : null;
  }

  /** How processes run that load a node compiled with sanitizers. */
  static NodeSanitizing sanitizing(Compilation compilation) throws IOException {
    return NodeSanitizing.of(folder(compilation));
  }

  private static void add(List<String> arguments, String option, Path value) {
    arguments.add(option);
    arguments.add(value.toString());
  }

  /** The compiled runtime; compiles it at the first use. */
  private Path runtime(
      Compilation compilation,
      Path environment,
      Path compiler,
      Path interfaces,
      List<Path> readable)
      throws IOException, InterruptedException {
    StringBuilder key = new StringBuilder(identity());
    FileTree files = compilation.application().harness().below(RosHarness.INTERFACES);
    for (String path : files.paths()) {
      key.append(path).append(' ').append(Sha256.hex(files.content(path).orElseThrow()));
    }
    String name = Sha256.hex(key.toString().getBytes(StandardCharsets.UTF_8));
    Path built = cache.entry(name);
    lock.lockInterruptibly();
    try {
      if (!Files.isDirectory(built)) {
        try (SharedCache.Draft compiled = cache.draft();
            SharedCache.Draft kept = cache.draft()) {
          compileRuntime(compilation, environment, compiler, interfaces, readable, compiled);
          copy(compiled.folder(), kept.folder());
          kept.addAs(name);
        }
      }
      return built;
    } finally {
      lock.unlock();
    }
  }

  private void compileRuntime(
      Compilation compilation,
      Path environment,
      Path compiler,
      Path interfaces,
      List<Path> readable,
      SharedCache.Draft draft)
      throws IOException, InterruptedException {
    Path into = draft.folder();
    List<String> arguments = new ArrayList<>(List.of("runtime", "--compiler", compiler.toString()));
    add(arguments, "--api", api);
    add(arguments, "--interfaces", interfaces);
    add(arguments, "--into", into);
    ToolResult end;
    try (OneTimeCompilation reported =
        OneTimeCompilation.of(
            compilation.progress(), "the runtime of C++ nodes", into, runtimeFiles())) {
      end =
          run(compilation, environment, arguments, into, readable, List.of(into), RUNTIME_AT_MOST);
    }
    if (end.code() != 0 || end.timedOut()) {
      throw new IOException(
          "the runtime of C++ nodes does not compile here: " + end.output() + end.errors());
    }
  }

  /** How many files the compiler makes of it: an object for each source, and its header. */
  private int runtimeFiles() throws IOException {
    try (Stream<Path> sources = Files.list(api.resolve("src"))) {
      return (int) sources.filter(file -> file.toString().endsWith(".cpp")).count() + 1;
    }
  }

  /**
   * Copies what the compiler left, so that it belongs to the agent, not to a user of the sandbox.
   */
  private static void copy(Path compiled, Path kept) throws IOException {
    Files.setPosixFilePermissions(kept, PosixFilePermissions.fromString("rwxr-xr-x"));
    List<Path> files;
    try (Stream<Path> all = Files.walk(compiled)) {
      files = all.filter(f -> Files.isRegularFile(f, LinkOption.NOFOLLOW_LINKS)).toList();
    }
    for (Path file : files) {
      Path target = kept.resolve(compiled.relativize(file).toString());
      Files.createDirectories(Objects.requireNonNull(target.getParent()));
      Files.write(target, Files.readAllBytes(file));
    }
  }

  private static ToolResult run(
      Compilation compilation,
      Path environment,
      List<String> arguments,
      Path working,
      List<Path> readable,
      List<Path> writable,
      Duration atMost)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(Environments.python(environment).toString(), "-s", "-P", "-m", BUILD));
    command.addAll(arguments);
    Path temporary = Files.createTempDirectory(compilation.scratch(), "build-");
    return compilation
        .sandbox()
        .run(
            Confinement.of(command, working, temporary, ProcessLimits.TOOL)
                .withEnvironment(Map.of("PYTHONUTF8", "1", "TMPDIR", temporary.toString()))
                .reading(readable)
                .writing(writable),
            atMost);
  }
}
