package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainLookup.Missing;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.python.environment.Environments;
import org.sitaf.agent.toolchain.python.environment.Interpreter;
import org.sitaf.agent.toolchain.python.environment.PipSettings;
import org.sitaf.agent.toolchain.python.environment.Requirements;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.activity.ros.RosNode;

/**
 * Compiles Python test applications to byte code, which finds syntax errors early, and runs them in
 * an environment with the component's packages.
 */
public final class PythonToolchain implements Toolchain {
  private static final String HARNESS = "harness";

  private final Interpreter interpreter;
  private final Environments environments;

  private final CppNodes cppNodes;

  private PythonToolchain(Interpreter interpreter, Environments environments, CppNodes cppNodes) {
    this.interpreter = interpreter;
    this.environments = environments;
    this.cppNodes = cppNodes;
  }

  /** Searches a Python that can create environments, and the runtime. */
  public static ToolchainLookup find(ToolchainPlaces places) {
    Path runtime = places.runtimes().resolve("runtime-python");
    if (!Files.isDirectory(runtime.resolve("sitaf_runtime"))) {
      return new Missing(
          runtime + " does not hold the runtime",
          "install the agent with its runtime folders next to it");
    }
    return Interpreter.find()
        .<ToolchainLookup>map(
            found ->
                new Found(
                    new PythonToolchain(
                        found,
                        new Environments(
                            found,
                            runtime,
                            new SharedCache(
                                places.cache().resolve("python"),
                                places.earlier("python").orElse(null)),
                            PipSettings.ofThisMachine()),
                        new CppNodes(
                            places.runtimes().resolve("runtime-cpp").resolve("ros"),
                            places.cache().resolve("cpp-nodes")))))
        .orElseGet(
            () ->
                new Missing(
                    "Python 3.11 or newer with venv and pip is not installed",
                    "apt-get install python3 python3-venv"));
  }

  @Override
  public Language language() {
    return Language.PYTHON;
  }

  @Override
  public String version() {
    return "Python " + interpreter.version();
  }

  @Override
  public String identity() throws IOException {
    String ros = ros().found().map(RosInstallation::identity).orElse("");
    return environments.identity() + cppNodes.identity() + ros;
  }

  @Override
  public void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    FileTree activity = compilation.application().activity().files();
    ActivityProfile profile = compilation.application().activity().profile();
    Map<String, String> roots = roots(profile);
    for (Map.Entry<String, String> root : roots.entrySet()) {
      copy(activity.below(root.getKey()), compilation.output().resolve(root.getValue()));
    }
    copy(compilation.application().harness(), compilation.output().resolve(HARNESS));
    if (profile.ros() == null) {
      RequiredModule.check(compilation, profile.component(), roots);
    }

    if (profile.ros() != null && profile.ros().isCpp()) {
      // The component's packages would run at the start of the interpreter, and change the compiled
      // runtime, which other users' builds share.
      Path environment = environment(Requirements.OF_NODES, compilation);
      cppNodes.compile(compilation, environment, interpreter.prefixes(), roots, ros(compilation));
    }

    // Without the component's packages, whose code would run at the start of the interpreter.
    Path temporary = Files.createTempDirectory(compilation.scratch(), "compile-");
    ToolResult end =
        compilation
            .sandbox()
            .run(
                Confinement.of(
                        List.of(
                            interpreter.executable().toString(),
                            "-I",
                            "-S",
                            environments.compiler().toString(),
                            compilation.output().toString()),
                        compilation.scratch(),
                        temporary,
                        ProcessLimits.TOOL)
                    .withEnvironment(Map.of("PYTHONUTF8", "1"))
                    .reading(interpreter.prefixes())
                    .reading(List.of(interpreter.executable(), environments.compiler()))
                    .writing(List.of(compilation.output())),
                compilation.atMost());
    if (end.timedOut()) {
      throw new CompilationException(
          "the compilation did not finish within " + compilation.atMost().toSeconds() + " s",
          List.of());
    }
    List<SourceDiagnostic> mistakes =
        end.output().lines().map(line -> diagnostic(line, compilation.output(), roots)).toList();
    if (!mistakes.isEmpty()) {
      throw new CompilationException("the sources do not compile", mistakes);
    }
    if (end.code() != 0) {
      throw new IOException(
          "the Python compiler ended with exit code " + end.code() + ": " + end.errors());
    }
  }

  @Override
  public CompiledApplication open(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    ActivityProfile profile = compilation.application().activity().profile();
    Map<String, String> roots = roots(profile);
    Map<Path, String> sources = new java.util.LinkedHashMap<>();
    roots.forEach((source, folder) -> sources.put(compilation.output().resolve(folder), source));
    List<Path> path = new ArrayList<>();
    path.add(compilation.output().resolve(HARNESS));
    path.addAll(sources.keySet());
    Path environment = environment(compilation);
    return new PythonApplication(
        environment,
        path,
        sources,
        compilation.application().entryPoint(),
        interpreter.prefixes(),
        environments.packages(environment),
        coverage(compilation, roots, environment),
        profile.sanitizers().isEmpty() ? null : CppNodes.sanitizing(compilation),
        ros(compilation));
  }

  /** The ROS 2 that a node runs with; null for what comes along. */
  private @Nullable RosInstallation ros(Compilation compilation)
      throws CompilationException, IOException {
    if (!compilation
        .application()
        .activity()
        .rosImplementation()
        .equals(Optional.of(RosImplementation.SYSTEM))) {
      return null;
    }
    RosInstallation.Lookup lookup = ros();
    return lookup
        .found()
        .orElseThrow(
            () ->
                new CompilationException(
                    "the node cannot run with an installed ROS 2: " + lookup.problem(), List.of()));
  }

  /** Searches for the ROS 2 of this machine, for nodes that run with it. */
  public RosInstallation.Lookup ros() throws IOException {
    return RosInstallation.find(interpreter.version());
  }

  private @Nullable Recording coverage(
      Compilation compilation, Map<String, String> roots, Path environment) {
    String sources = compilation.application().activity().profile().component().sources();
    if (!compilation.coverage() || sources == null) {
      return null;
    }
    RosNode node = compilation.application().activity().profile().ros();
    if (node != null && node.isCpp()) {
      return CppNodes.recording(compilation, withTrailingSlash(sources));
    }
    String folder = withTrailingSlash(sources);
    List<Path> readable = new ArrayList<>(interpreter.prefixes());
    readable.add(environment);
    return new PythonCoverage(
        Environments.python(environment),
        readable,
        compilation.output().resolve(Objects.requireNonNull(roots.get(folder))),
        folder,
        compilation.scratch().resolve("coverage"),
        compilation.sandbox());
  }

  private Path environment(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    return environment(
        Requirements.of(
            compilation.application().activity().profile(),
            ActivityLock.of(compilation.application().activity().files()).orElse(null),
            compilation.activity()),
        compilation);
  }

  private Path environment(Requirements requirements, Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    return environments.with(
        requirements,
        compilation.scratch(),
        compilation.application().activity().profile().limits().preparation(),
        compilation.sandbox());
  }

  /** The activity's folders of modules, and the name of the copy of each. */
  private static Map<String, String> roots(ActivityProfile profile) throws CompilationException {
    Component component = profile.component();
    Map<String, String> roots = new java.util.LinkedHashMap<>();
    put(roots, component.adapter(), "adapter");
    put(roots, component.sources(), "component");
    if (component.library() != null && !Requirements.isWheel(component.library())) {
      // A package is imported by its own name, from its parent folder.
      String library = component.library().replaceAll("/+$", "");
      put(roots, library.substring(0, library.lastIndexOf('/') + 1), "library");
    }
    for (int i = 0; i < profile.libraries().size(); i++) {
      String library = profile.libraries().get(i);
      if (Requirements.isWheel(library)) {
        continue;
      }
      if (library.matches(".*\\.(jar|so|zip)")) {
        throw new CompilationException(
            "the component's libraries cannot be used",
            List.of(
                SourceDiagnostic.ofFile(
                    "activity/activity.yaml",
                    "library "
                        + library
                        + ": expected a folder of Python modules or a wheel (.whl); name packages"
                        + " of PyPI in requirements.txt")));
      }
      put(roots, library, "library" + (i + 1));
    }
    return roots;
  }

  private static void put(Map<String, String> roots, @Nullable String folder, String name) {
    if (folder != null) {
      roots.putIfAbsent(withTrailingSlash(folder), name);
    }
  }

  private static String withTrailingSlash(String folder) {
    return folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
  }

  /** Maps a compiler error in a copy to the original file. */
  static SourceDiagnostic diagnostic(String line, Path output, Map<String, String> roots) {
    String[] parts = line.split("\t", 4);
    if (parts.length < 4 || !parts[1].matches("\\d{1,9}") || !parts[2].matches("\\d{1,9}")) {
      return new SourceDiagnostic("", 0, 0, line, false);
    }
    if (!parts[0].startsWith(output + "/")) {
      // Of no file, or of a header of the system.
      return new SourceDiagnostic(
          parts[0], Integer.parseInt(parts[1]), Integer.parseInt(parts[2]), parts[3], false);
    }
    String copy = output.relativize(Path.of(parts[0])).toString();
    String file = copy;
    for (Map.Entry<String, String> root : roots.entrySet()) {
      if (copy.startsWith(root.getValue() + "/")) {
        file = "activity/" + root.getKey() + copy.substring(root.getValue().length() + 1);
      }
    }
    return new SourceDiagnostic(
        file,
        Integer.parseInt(parts[1]),
        Integer.parseInt(parts[2]),
        parts[3],
        copy.startsWith(HARNESS + "/"));
  }

  private static void copy(FileTree files, Path folder) throws IOException {
    for (String path : files.paths()) {
      if (!path.endsWith(".pyc")) {
        Path target = folder.resolve(path);
        Files.createDirectories(target.getParent());
        Files.write(target, files.content(path).orElseThrow());
      }
    }
  }
}
