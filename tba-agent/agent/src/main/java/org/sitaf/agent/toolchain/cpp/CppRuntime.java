package org.sitaf.agent.toolchain.cpp;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.OneTimeCompilation;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/**
 * The runtime of C++ test applications, compiled from sources once per machine and compiler into a
 * shared library and a precompiled header. The name of its folder is a digest of all inputs,
 * including the machine's headers, which may change without a new version.
 */
final class CppRuntime {
  /** Its libraries, as pkg-config names them. */
  static final List<String> LIBRARIES = List.of("grpc++", "protobuf", "expat");

  /** The header that every generated source includes. */
  static final String PRECOMPILED = "sitaf/runtime/test_application.hpp";

  private static final Duration TOOL_TIMEOUT = Duration.ofMinutes(15);

  /** Time during which a result is reused without checks. */
  private static final Duration REUSE_PERIOD = Duration.ofSeconds(2);

  /** Allows for headers that were installed just before, together with the compiler. */
  private static final Duration CLOCK_STEP = Duration.ofSeconds(2);

  private static final String INPUTS = ".inputs";
  private static final String RULE = "runtime";

  private final Compiler compiler;
  private final Path sources;
  private final Path cache;
  private final @Nullable Path earlier;
  private @Nullable Built built;
  private long builtNanos;

  /**
   * Creates a runtime, which may have been compiled earlier.
   *
   * @param sources holds {@code include}, {@code src} and {@code proto}
   * @param earlier another cache, whose result is used if it has one; null for none
   */
  CppRuntime(Compiler compiler, Path sources, Path cache, @Nullable Path earlier) {
    this.compiler = compiler;
    this.sources = sources;
    this.cache = cache;
    this.earlier = earlier;
  }

  /**
   * The compiled runtime.
   *
   * @param include folder of the headers
   * @param precompiled folder of the precompiled header
   * @param library folder of the shared library
   */
  record Built(Path include, Path precompiled, Path library) {
    /** A digest of everything that determines the result. */
    String name() {
      return library.getParent().getFileName().toString();
    }
  }

  /**
   * Digest of the inputs that are known before the compilation: sources, compiler, library
   * versions.
   */
  private String base() throws IOException {
    Digest digest = new Digest();
    digest.add(compiler.identity() + " " + Compiler.OPTIONS);
    for (String library : LIBRARIES) {
      digest.add(PkgConfig.version(library).orElse("none"));
    }
    digest.addFolder(sources);
    return digest.hexadecimal();
  }

  /** The compiled runtime; compiles it if necessary. */
  Built build() throws IOException, InterruptedException {
    return build(text -> {});
  }

  /**
   * The compiled runtime; compiles it if necessary.
   *
   * @param progress receives how far a compilation is
   */
  synchronized Built build(Consumer<String> progress) throws IOException, InterruptedException {
    Built last = built;
    // A build calls this several times.
    if (last != null && System.nanoTime() - builtNanos < REUSE_PERIOD.toNanos()) {
      return last;
    }
    String base = base();
    Path folder = current(base);
    if (folder == null) {
      Files.createDirectories(cache);
      // Agents and commands on one machine may share the cache.
      try (FileChannel channel =
              FileChannel.open(
                  cache.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
          FileLock lock = channel.lock()) {
        folder = current(base);
        if (lock.isValid() && folder == null) {
          folder = add(base, progress);
          deleteOthers(folder);
        }
      }
    }
    Path whole = Objects.requireNonNull(folder, "the lock of the cache was lost");
    built =
        new Built(sources.resolve("include"), whole.resolve("precompiled"), whole.resolve("lib"));
    builtNanos = System.nanoTime();
    return built;
  }

  /** The folder of an earlier result, if all headers are unchanged; otherwise null. */
  private @Nullable Path current(String base) throws IOException {
    Path own = current(base, cache);
    if (own != null || earlier == null) {
      return own;
    }
    try {
      return current(base, earlier);
    } catch (IOException e) {
      // It belongs to another user.
      return null;
    }
  }

  private static @Nullable Path current(String base, Path cache) throws IOException {
    try (DataInputStream in =
        new DataInputStream(
            new BufferedInputStream(Files.newInputStream(cache.resolve(base + INPUTS))))) {
      Inputs inputs = Inputs.read(in);
      Path folder = cache.resolve(name(base, inputs));
      return Files.isDirectory(folder) && InputCheck.isCurrentOnMachine(inputs) ? folder : null;
    } catch (NoSuchFileException | EOFException e) {
      return null;
    }
  }

  private static String name(String base, Inputs inputs) {
    Digest digest = new Digest();
    digest.add(base);
    inputs
        .digestsOnMachine()
        .forEach(
            (path, sha256) -> {
              digest.add(path);
              digest.add(sha256);
            });
    return digest.hexadecimal();
  }

  private Path add(String base, Consumer<String> progress)
      throws IOException, InterruptedException {
    Path fresh = cache.resolve("new");
    Folders.delete(fresh);
    Inputs inputs = compile(fresh, progress);
    Path folder = cache.resolve(name(base, inputs));
    if (!Files.isDirectory(folder)) {
      Files.move(fresh, folder, StandardCopyOption.ATOMIC_MOVE);
    }
    Path noted = Files.createTempFile(cache, "new", INPUTS);
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(noted)))) {
      inputs.write(out);
    }
    Files.move(noted, cache.resolve(base + INPUTS), StandardCopyOption.ATOMIC_MOVE);
    return folder;
  }

  /** Compiles the runtime and returns the inputs of this machine. */
  private Inputs compile(Path fresh, Consumer<String> progress)
      throws IOException, InterruptedException {
    long startMillis = System.currentTimeMillis();
    Path generated = Files.createDirectories(fresh.resolve("generated"));
    Path objects = Files.createDirectories(fresh.resolve("objects"));
    Path library = Files.createDirectories(fresh.resolve("lib"));
    String plugin = Tools.find("grpc_cpp_plugin").map(Path::toString).orElse("grpc_cpp_plugin");
    Path proto = sources.resolve("proto");
    run(
        fresh,
        List.of(
            "protoc",
            "-I",
            proto.toString(),
            "--cpp_out=" + generated,
            "--grpc_out=" + generated,
            "--plugin=protoc-gen-grpc=" + plugin,
            "sitaf/sim/v1/simulation.proto"));
    List<List<String>> commands = new ArrayList<>();
    List<String> compileFlags = flags("--cflags");
    for (Path folder : List.of(sources.resolve("src"), generated)) {
      for (Path source : sourcesIn(folder)) {
        List<String> command = compilerCommand();
        command.addAll(
            List.of("-I", sources.resolve("src").toString(), "-I", generated.toString()));
        command.addAll(compileFlags);
        command.addAll(List.of("-c", source.toString()));
        command.addAll(List.of("-o", objects.resolve(commands.size() + ".o").toString()));
        command.addAll(dependencyOptions(objects, commands.size()));
        commands.add(command);
      }
    }
    Path precompiled = fresh.resolve("precompiled").resolve(PRECOMPILED + ".gch");
    Files.createDirectories(precompiled.getParent());
    List<String> header = compilerCommand();
    header.addAll(
        List.of("-x", "c++-header", sources.resolve("include").resolve(PRECOMPILED).toString()));
    header.addAll(List.of("-o", precompiled.toString()));
    header.addAll(dependencyOptions(objects, commands.size()));
    commands.add(header);
    List<ToolResult> ends;
    try (OneTimeCompilation reported =
        OneTimeCompilation.of(
            progress, "the runtime of C++ test applications", fresh, commands.size())) {
      ends = Parallel.run(commands, command -> end(fresh, command));
    }
    for (int i = 0; i < ends.size(); i++) {
      require(ends.get(i), String.join(" ", commands.get(i)));
    }
    List<String> link =
        new ArrayList<>(List.of(compiler.program().toString(), "-shared", "-pthread"));
    link.addAll(List.of("-o", library.resolve("libsitaf_runtime.so").toString()));
    for (int i = 0; i < commands.size() - 1; i++) {
      link.add(objects.resolve(i + ".o").toString());
    }
    link.addAll(flags("--libs"));
    link.add("-ldl");
    run(fresh, link);
    Inputs inputs = inputs(objects, commands.size(), fresh, startMillis);
    Folders.delete(objects);
    Folders.delete(generated);
    return inputs;
  }

  private static List<String> dependencyOptions(Path objects, int number) {
    return List.of("-MD", "-MT", RULE, "-MF", objects.resolve(number + ".d").toString());
  }

  private Inputs inputs(Path objects, int count, Path fresh, long startMillis) throws IOException {
    Set<String> opened = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      opened.addAll(
          DependencyFile.rule(RULE, Files.readString(objects.resolve(i + ".d")))
              .orElseThrow(() -> new IOException("the compiler does not list its inputs")));
    }
    opened.removeIf(path -> path.startsWith(fresh + "/") || path.startsWith(sources + "/"));
    return InputCheck.ofMachine(opened, startMillis + CLOCK_STEP.toMillis())
        .orElseThrow(
            () ->
                new IOException(
                    "headers of this machine changed while the runtime of C++ test applications"
                        + " was compiled; start the build again"));
  }

  private List<String> compilerCommand() {
    List<String> command = new ArrayList<>(List.of(compiler.program().toString()));
    command.addAll(Compiler.OPTIONS);
    command.add(Compiler.WITHOUT_WARNINGS);
    command.addAll(List.of("-I", sources.resolve("include").toString()));
    return command;
  }

  private static List<String> flags(String which) throws IOException {
    return PkgConfig.flags(which, LIBRARIES)
        .orElseThrow(() -> new IOException("pkg-config does not know all of " + LIBRARIES));
  }

  private static List<Path> sourcesIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(".cpp") || file.toString().endsWith(".cc"))
          .sorted()
          .toList();
    }
  }

  private static void run(Path fresh, List<String> command)
      throws IOException, InterruptedException {
    require(end(fresh, command), String.join(" ", command));
  }

  /** Runs without a sandbox: the runtime is part of SITAF and has no code of users. */
  private static ToolResult end(Path fresh, List<String> command)
      throws IOException, InterruptedException {
    // A separate folder, because the end of a tool also ends other processes of its folder.
    Path working = Files.createTempDirectory(fresh, "tool");
    ToolResult end =
        Sandbox.none()
            .run(Confinement.of(command, working, working, ProcessLimits.TOOL), TOOL_TIMEOUT);
    Folders.delete(working);
    return end;
  }

  private static void require(ToolResult end, String what) throws IOException {
    if (end.code() != 0) {
      throw new IOException(
          "the runtime of C++ test applications cannot be compiled here: "
              + what
              + ": "
              + (end.timedOut()
                  ? "timeout"
                  : "exit code " + end.code() + " " + end.errors().strip()));
    }
  }

  private void deleteOthers(Path current) throws IOException {
    try (Stream<Path> folders = Files.list(cache)) {
      for (Path other :
          folders.filter(Files::isDirectory).filter(f -> !f.equals(current)).toList()) {
        // A running process may still open files in it, so it is deleted after a day.
        if (Files.getLastModifiedTime(other).toMillis()
            < System.currentTimeMillis() - Duration.ofDays(1).toMillis()) {
          Folders.delete(other);
        }
      }
    }
  }
}
