package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.tools.ToolProvider;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainLookup.Missing;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.java.confined.Wire;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.harness.TestApplication;

/**
 * Compiles Java test applications in the sandbox. Only annotation processors that the administrator
 * allows run, so the compilation executes no code of users.
 */
public final class JavaToolchain implements Toolchain {
  private static final String ACTIVITY = "activity/";

  private final List<Path> runtimeJars;
  private final @Nullable Path archive;
  private final @Nullable CoverageTool coverage;
  private final CompilerSetup compiler;
  private final CompilerProcesses compilers;
  private final MavenPackages packages;

  private JavaToolchain(
      CompilerSetup compiler, @Nullable Path archive, @Nullable CoverageTool coverage, Path cache) {
    this.compiler = compiler;
    this.compilers = new CompilerProcesses(compiler, cache.resolve("compilers"));
    this.packages = new MavenPackages(cache);
    this.runtimeJars = compiler.runtime();
    this.archive = archive;
    this.coverage = coverage;
  }

  /** Checks that the Java of the agent is a JDK and that the runtime is installed. */
  public static ToolchainLookup find(ToolchainPlaces places) {
    if (ToolProvider.getSystemJavaCompiler() == null) {
      return new Missing(
          "the Java version of the agent ("
              + System.getProperty("java.home")
              + ") is a runtime without a compiler",
          "run the agent with a JDK 17: apt-get install openjdk-17-jdk-headless");
    }
    Path runtimes = places.runtimes();
    try {
      List<Path> runtime = RuntimeJars.in(runtimes.resolve("runtime-java"));
      CompilerSetup compiler =
          new CompilerSetup(
              RuntimeJars.compiler(runtimes.resolve("compiler-java")),
              RuntimeJars.archive(runtimes.resolve("compiler-java.jsa")).orElse(null),
              runtime,
              RuntimeJars.required(places.annotationProcessors()));
      return new Found(
          new JavaToolchain(
              compiler,
              RuntimeJars.archive(runtimes.resolve("runtime-java.jsa")).orElse(null),
              RuntimeJars.recorder(runtimes.resolve("coverage-java"))
                  .map(jar -> new CoverageTool(jar, RuntimeJars.jars(compiler.program())))
                  .orElse(null),
              places.cache().resolve("java")));
    } catch (IOException | UncheckedIOException e) {
      return new Missing(
          String.valueOf(e.getMessage()), "install the agent with its runtime folders next to it");
    }
  }

  @Override
  public Language language() {
    return Language.JAVA;
  }

  @Override
  public Optional<String> missingDebugger() {
    return JavaDebuggee.missingTool();
  }

  @Override
  public String version() {
    return "javac " + System.getProperty("java.version");
  }

  @Override
  public String identity() throws IOException {
    return version() + ' ' + compiler.identity();
  }

  /** The compiler gets no other files than sources and jars. */
  @Override
  public boolean readsElsewhere(String path, ActivityProfile profile) {
    return profile.component().packageName() != null && path.equals(ActivityLock.FILE)
        || path.endsWith(".jar") && Toolchain.super.readsElsewhere(path, profile);
  }

  @Override
  public Optional<CompiledApplication> openEarly(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    // Packages may have to be downloaded first.
    return compilation.application().activity().profile().component().packageName() == null
        ? Optional.of(application(compilation, true))
        : Optional.empty();
  }

  @Override
  public CompiledApplication open(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    return application(compilation, false);
  }

  private JavaApplication application(Compilation compilation, boolean early)
      throws CompilationException, InterruptedException, IOException {
    List<Path> classPath = new ArrayList<>(runtimeJars);
    classPath.addAll(libraries(compilation));
    classPath.add(compilation.output());
    JavaCoverage recording =
        !compilation.coverage() || coverage == null
            ? null
            : JavaCoverage.of(compilation, coverage).orElse(null);
    return new JavaApplication(
        classPath,
        compilation.application().entryPoint(),
        early,
        archive,
        packages(compilation),
        recording);
  }

  @Override
  public void startAhead(Sandbox sandbox) throws IOException, InterruptedException {
    compilers.startAhead(sandbox);
  }

  @Override
  public void stop() {
    compilers.stop();
  }

  @Override
  public void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    TestApplication application = compilation.application();
    List<Path> libraries = libraries(compilation);
    List<JavaSource> sources = JavaSource.of(application);
    copyResources(application, compilation.output());
    compilers.compile(
        compiler -> write(compilation, libraries, sources, compiler),
        new CompilerAnswer(
            sources,
            application.activity().profile().component().className(),
            compilation.output()),
        compilation.sandbox(),
        compilation.atMost());
  }

  private static void write(
      Compilation compilation,
      List<Path> libraries,
      List<JavaSource> sources,
      OutputStream compiler)
      throws IOException {
    FileTree files = compilation.application().activity().files();
    for (String path : files.paths()) {
      // Send all jars: the manifest of one may refer to another.
      if (path.endsWith(".jar")) {
        Wire.write(compiler, Wire.JAR, utf8(ACTIVITY + path), files.content(path).orElseThrow());
      }
    }
    for (Path library : libraries) {
      String path;
      if (library.startsWith(compilation.activity())) {
        path = ACTIVITY + compilation.activity().relativize(library);
      } else {
        path = "packages/" + library.getFileName();
        Wire.write(compiler, Wire.JAR, utf8(path), Files.readAllBytes(library));
      }
      Wire.write(compiler, Wire.CLASS_PATH, path);
    }
    for (int i = 0; i < sources.size(); i++) {
      JavaSource source = sources.get(i);
      Wire.write(compiler, Wire.SOURCE, Integer.toString(i), source.path(), source.text());
    }
    String entryPoint = compilation.application().entryPoint();
    Wire.write(
        compiler,
        Wire.COMPONENT,
        compilation.application().activity().profile().component().className(),
        entryPoint.substring(0, entryPoint.lastIndexOf('.') + 1));
    Wire.write(compiler, Wire.COMPILE, new byte[0]);
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /**
   * The component's own library, the external ones, each of which must be a jar of the activity,
   * and its package.
   */
  private List<Path> libraries(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    TestApplication application = compilation.application();
    ActivityProfile profile = application.activity().profile();
    List<SourceDiagnostic> problems = new ArrayList<>();
    List<Path> jars = new ArrayList<>();
    List<String> wanted = new ArrayList<>(profile.libraries());
    if (profile.component().library() != null) {
      wanted.add(0, profile.component().library());
    }
    for (String library : wanted) {
      if (!library.endsWith(".jar")) {
        problems.add(inProfile("library " + library + ": expected a .jar for a Java component"));
      } else if (!application.activity().files().contains(library)) {
        problems.add(inProfile("library " + library + ": no such file in the activity"));
      } else {
        jars.add(compilation.activity().resolve(library));
      }
    }
    if (!problems.isEmpty()) {
      throw new CompilationException("the component's libraries cannot be used", problems);
    }
    String packageName = profile.component().packageName();
    if (packageName != null) {
      packages.jars(packageName, compilation).forEach(jar -> jars.add(jar.file()));
    }
    return jars;
  }

  private List<ResolvedPackage> packages(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    List<ResolvedPackage> resolved = new ArrayList<>();
    String wanted = compilation.application().activity().profile().component().packageName();
    if (wanted != null) {
      for (MavenPackages.Jar jar : packages.jars(wanted, compilation)) {
        resolved.add(jar.resolved());
      }
    }
    return resolved.stream().sorted().toList();
  }

  static SourceDiagnostic inProfile(String message) {
    return SourceDiagnostic.ofFile("activity/activity.yaml", message);
  }

  private static void copyResources(TestApplication application, Path classes)
      throws CompilationException, IOException {
    for (Map.Entry<String, byte[]> entry : JavaSource.resources(application).entrySet()) {
      write(classes, entry.getKey(), entry.getValue());
    }
  }

  /** Writes a file of the application; fails if its folder has the name of another file. */
  static void write(Path classes, String path, byte[] content)
      throws CompilationException, IOException {
    Path file = classes.resolve(path);
    try {
      Files.createDirectories(file.getParent());
      Files.write(file, content);
    } catch (FileSystemException e) {
      boolean isFolder = Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS);
      Path folder = file.getParent();
      while (!isFolder && !Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
        folder = folder.getParent();
      }
      if (isFolder || !Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        throw new CompilationException(
            "the component's files conflict",
            List.of(
                inProfile(
                    path
                        + ": a file and a folder have the same name; rename the component's"
                        + " file")));
      }
      throw e;
    }
  }
}
