package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainLookup.Missing;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.CppBuild;

/**
 * Compiles C++ test applications with this machine's compiler. The runtime, the only part that uses
 * gRPC, is compiled once per machine and compiler and shared by all applications.
 */
public final class CppToolchain implements Toolchain {
  private static final String REMEDY = "./sitaf doctor --install cpp";

  /** Environment variable that selects the compiler, as for make and CMake. */
  private static final String CHOICE = "CXX";

  private final Compiler compiler;
  private final CppRuntime runtime;
  private final ObjectCache objects;

  private CppToolchain(Compiler compiler, CppRuntime runtime, ObjectCache objects) {
    this.compiler = compiler;
    this.runtime = runtime;
    this.objects = objects;
  }

  /** Searches the compiler and the libraries of the runtime. */
  public static ToolchainLookup find(ToolchainPlaces places) {
    String named = System.getenv(CHOICE);
    Optional<Path> program = Compiler.find(named);
    if (program.isEmpty()) {
      return named == null || named.isBlank()
          ? new Missing("neither g++ nor clang++ is installed", REMEDY)
          : new Missing(
              CHOICE + " names '" + named + "', which is not an executable program",
              "set " + CHOICE + " to a C++ compiler, or unset it");
    }
    List<String> missing = new ArrayList<>();
    for (String tool : List.of(PkgConfig.PROGRAM, "protoc", "grpc_cpp_plugin")) {
      if (Tools.find(tool).isEmpty()) {
        missing.add(tool);
      }
    }
    if (missing.isEmpty()) {
      for (String library : CppRuntime.LIBRARIES) {
        if (PkgConfig.version(library).isEmpty()) {
          missing.add("the library " + library);
        }
      }
    }
    if (!missing.isEmpty()) {
      return new Missing(
          program.get().getFileName()
              + " is there, but "
              + String.join(" and ", missing)
              + (missing.size() == 1 ? " is not" : " are not"),
          REMEDY);
    }
    Path sources = places.runtimes().resolve("runtime-cpp");
    if (!Files.isDirectory(sources.resolve("src"))) {
      return new Missing(
          sources + " does not hold the runtime of C++ test applications",
          "install the agent with its runtime folders next to it");
    }
    Compiler compiler = Compiler.of(program.get());
    Path cache = places.cache().resolve("cpp");
    return new Found(
        new CppToolchain(
            compiler,
            new CppRuntime(
                compiler,
                sources,
                cache.resolve("runtime"),
                places.earlier("cpp").map(earlier -> earlier.resolve("runtime")).orElse(null)),
            new ObjectCache(cache.resolve("objects"))));
  }

  @Override
  public Language language() {
    return Language.CPP;
  }

  @Override
  public Optional<String> missingDebugger() {
    return Tools.find("gdb").isPresent()
        ? Optional.empty()
        : Optional.of("gdb is not installed; install it with: apt-get install gdb");
  }

  @Override
  public String version() {
    return compiler.version();
  }

  @Override
  public String compiler(ActivityProfile profile) {
    CppBuild build = profile.component().cpp();
    List<String> options = new ArrayList<>(Compiler.options(build.standard()));
    options.addAll(Compiler.sanitizing(profile.sanitizers()));
    build.defines().forEach(define -> options.add("-D" + define));
    return version() + " " + String.join(" ", options);
  }

  @Override
  public String identity() throws IOException, InterruptedException {
    return String.join(
        "\n",
        compiler.identity() + " " + Compiler.OPTIONS,
        Linking.LIBRARIES_BY_NAME,
        runtime.build().name());
  }

  @Override
  public boolean readsElsewhere(String path, ActivityProfile profile) {
    // Sources may include, and linkers may read, any file there.
    return true;
  }

  @Override
  public void prepare(Compilation compilation) throws IOException, InterruptedException {
    runtime.build(compilation.progress());
  }

  @Override
  public boolean isCurrent(Compilation compilation, Path compiled) throws IOException {
    return Linking.isCurrent(compilation, compiled);
  }

  @Override
  public void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    CppRuntime.Built built = runtime.build();
    new CppCompilation(compilation, compiler, built, objects).run();
  }

  @Override
  public CompiledApplication open(Compilation compilation)
      throws InterruptedException, IOException {
    CppRuntime.Built built = runtime.build();
    return new CppApplication(
        compilation.output(),
        compilation.application().entryPoint(),
        built.library(),
        !compilation.application().activity().profile().sanitizers().isEmpty(),
        CppCoverage.of(compilation, compiler).orElse(null));
  }
}
