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
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/**
 * The runtime of C++ test applications: kept as sources, compiled once for a machine and a compiler
 * into a shared library and a precompiled header, in a folder named after all that decides: also
 * after the machine's headers, which may change while no version does.
 */
final class CppRuntime {
  /** What it is made of, as pkg-config names it. */
  static final List<String> LIBRARIES = List.of("grpc++", "protobuf", "expat");

  /** What every generated source needs. */
  static final String PRECOMPILED = "sitaf/runtime/test_application.hpp";

  private static final Duration PATIENCE = Duration.ofMinutes(15);

  /** How long what was found to be current is taken to be so. */
  private static final Duration LASTS = Duration.ofSeconds(2);

  /**
   * What an {@link InputCheck} allows for; here a header may have come with the compiler just now.
   */
  private static final Duration CLOCK_STEP = Duration.ofSeconds(2);

  private static final String INPUTS = ".inputs";
  private static final String RULE = "runtime";

  private final Compiler compiler;
  private final Path sources;
  private final Path cache;
  private @Nullable Built built;
  private long builtNanos;

  /**
   * A runtime that may have been compiled already.
   *
   * @param sources holds {@code include}, {@code src} and {@code proto}
   */
  CppRuntime(Compiler compiler, Path sources, Path cache) {
    this.compiler = compiler;
    this.sources = sources;
    this.cache = cache;
  }

  /**
   * The compiled runtime.
   *
   * @param include folder of the headers
   * @param precompiled folder of the precompiled header
   * @param library folder of the shared library
   */
  record Built(Path include, Path precompiled, Path library) {
    /** Stands for all that decides about it. */
    String name() {
      return library.getParent().getFileName().toString();
    }
  }

  /** Of what is known before anything is compiled: sources, compiler and libraries' versions. */
  private String base() throws IOException {
    Digest digest = new Digest();
    digest.add(compiler.identity() + " " + Compiler.OPTIONS);
    List<String> question = new ArrayList<>(List.of("pkg-config", "--modversion"));
    question.addAll(LIBRARIES);
    digest.add(Tools.ask(question).orElse("none"));
    digest.addFolder(sources);
    return digest.hexadecimal();
  }

  /** The compiled runtime; compiles it where nobody has done so yet. */
  synchronized Built build() throws IOException, InterruptedException {
    Built last = built;
    // A build asks several times.
    if (last != null && System.nanoTime() - builtNanos < LASTS.toNanos()) {
      return last;
    }
    String base = base();
    Path folder = current(base);
    if (folder == null) {
      Files.createDirectories(cache);
      // Agents and commands of one machine may share the cache.
      try (FileChannel channel =
              FileChannel.open(
                  cache.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
          FileLock lock = channel.lock()) {
        folder = current(base);
        if (lock.isValid() && folder == null) {
          folder = add(base);
          deleteAllBut(folder);
        }
      }
    }
    Path whole = Objects.requireNonNull(folder, "the lock of the cache was lost");
    built =
        new Built(sources.resolve("include"), whole.resolve("precompiled"), whole.resolve("lib"));
    builtNanos = System.nanoTime();
    return built;
  }

  /** The folder of what was compiled, where all headers are still those of then; null without. */
  private @Nullable Path current(String base) throws IOException {
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

  private Path add(String base) throws IOException, InterruptedException {
    Path fresh = cache.resolve("new");
    Folders.delete(fresh);
    Inputs inputs = compile(fresh);
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

  /** Compiles it, and says what of this machine went into it. */
  private Inputs compile(Path fresh) throws IOException, InterruptedException {
    long begunMillis = System.currentTimeMillis();
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
    for (Path folder : List.of(sources.resolve("src"), generated)) {
      for (Path source : sourcesIn(folder)) {
        List<String> command = compiling();
        command.addAll(
            List.of("-I", sources.resolve("src").toString(), "-I", generated.toString()));
        command.addAll(flags("--cflags"));
        command.addAll(List.of("-c", source.toString()));
        command.addAll(List.of("-o", objects.resolve(commands.size() + ".o").toString()));
        command.addAll(noting(objects, commands.size()));
        commands.add(command);
      }
    }
    Path precompiled = fresh.resolve("precompiled").resolve(PRECOMPILED + ".gch");
    Files.createDirectories(precompiled.getParent());
    List<String> header = compiling();
    header.addAll(
        List.of("-x", "c++-header", sources.resolve("include").resolve(PRECOMPILED).toString()));
    header.addAll(List.of("-o", precompiled.toString()));
    header.addAll(noting(objects, commands.size()));
    commands.add(header);
    List<ToolEnd> ends = Parallel.run(commands, command -> end(fresh, command));
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
    Inputs inputs = inputs(objects, commands.size(), fresh, begunMillis);
    Folders.delete(objects);
    Folders.delete(generated);
    return inputs;
  }

  private static List<String> noting(Path objects, int number) {
    return List.of("-MD", "-MT", RULE, "-MF", objects.resolve(number + ".d").toString());
  }

  private Inputs inputs(Path objects, int count, Path fresh, long begunMillis) throws IOException {
    Set<String> opened = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      opened.addAll(
          DependencyFile.rule(RULE, Files.readString(objects.resolve(i + ".d")))
              .orElseThrow(() -> new IOException("the compiler does not say what it has read")));
    }
    opened.removeIf(path -> path.startsWith(fresh + "/") || path.startsWith(sources + "/"));
    return InputCheck.ofMachine(opened, begunMillis + CLOCK_STEP.toMillis())
        .orElseThrow(
            () ->
                new IOException(
                    "headers of this machine changed while the runtime of C++ test applications"
                        + " was compiled; start the build again"));
  }

  private List<String> compiling() {
    List<String> command = new ArrayList<>(List.of(compiler.program().toString()));
    command.addAll(Compiler.OPTIONS);
    command.addAll(List.of("-I", sources.resolve("include").toString()));
    return command;
  }

  private static List<String> flags(String which) throws IOException {
    List<String> question = new ArrayList<>(List.of("pkg-config", which));
    question.addAll(LIBRARIES);
    String answer =
        Tools.ask(question)
            .orElseThrow(() -> new IOException("pkg-config does not know all of " + LIBRARIES));
    return Arrays.stream(answer.split("\\s+")).filter(word -> !word.isEmpty()).toList();
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

  /** Outside of any sandbox: the runtime is SITAF's own, and nothing of a user's is in it. */
  private static ToolEnd end(Path fresh, List<String> command)
      throws IOException, InterruptedException {
    // A folder of its own: when a tool ends, all that works in its folder ends with it.
    Path working = Files.createTempDirectory(fresh, "tool");
    ToolEnd end =
        Sandbox.none().run(Confinement.of(command, working, working, ProcessLimits.TOOL), PATIENCE);
    Folders.delete(working);
    return end;
  }

  private static void require(ToolEnd end, String what) throws IOException {
    if (end.code() != 0) {
      throw new IOException(
          "the runtime of C++ test applications cannot be compiled here: "
              + what
              + ": "
              + (end.gaveUp()
                  ? "it took too long"
                  : "exit code " + end.code() + " " + end.errors().strip()));
    }
  }

  private void deleteAllBut(Path kept) throws IOException {
    try (Stream<Path> folders = Files.list(cache)) {
      for (Path other : folders.filter(Files::isDirectory).filter(f -> !f.equals(kept)).toList()) {
        // A process that runs on it has its files open; what it has not opened yet it would miss,
        // so that a day passes first.
        if (Files.getLastModifiedTime(other).toMillis()
            < System.currentTimeMillis() - Duration.ofDays(1).toMillis()) {
          Folders.delete(other);
        }
      }
    }
  }
}
