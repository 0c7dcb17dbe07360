package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainLookup.Missing;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.harness.TestApplication;

/**
 * Compiles Java test applications in this process, without annotation processors: no code of the
 * user runs while it is compiled.
 */
public final class JavaToolchain implements Toolchain {
  private final List<Path> runtimeJars;
  private final @Nullable Path archive;
  private final @Nullable Path recorder;
  private final MavenPackages packages;

  private JavaToolchain(
      List<Path> runtimeJars,
      @Nullable Path archive,
      @Nullable Path recorder,
      MavenPackages packages) {
    this.packages = packages;
    this.runtimeJars = List.copyOf(runtimeJars);
    this.archive = archive;
    this.recorder = recorder;
  }

  /** Looks whether the Java that runs the agent can compile, and whether the runtime is there. */
  public static ToolchainLookup find(ToolchainPlaces places) {
    if (ToolProvider.getSystemJavaCompiler() == null) {
      return new Missing(
          "the Java that runs the agent ("
              + System.getProperty("java.home")
              + ") is a runtime without a compiler",
          "run the agent with a JDK 17: apt-get install openjdk-17-jdk-headless");
    }
    try {
      return new Found(
          new JavaToolchain(
              RuntimeJars.in(places.runtimes().resolve("runtime-java")),
              RuntimeJars.archive(places.runtimes().resolve("runtime-java.jsa")).orElse(null),
              RuntimeJars.recorder(places.runtimes().resolve("coverage-java")).orElse(null),
              new MavenPackages(places.cache().resolve("java"))));
    } catch (IOException e) {
      return new Missing(
          String.valueOf(e.getMessage()), "install the agent with its runtime folders beside it");
    }
  }

  @Override
  public Language language() {
    return Language.JAVA;
  }

  @Override
  public String version() {
    return "javac " + System.getProperty("java.version");
  }

  @Override
  public String identity() throws IOException {
    StringBuilder identity = new StringBuilder(version());
    identity.append(' ').append(JavaCompilation.OPTIONS);
    for (Path jar : runtimeJars) {
      // Jars are replaced as a whole; reading megabytes for each build would tell no more.
      identity.append('\n').append(jar).append(' ').append(Files.size(jar));
      identity.append(' ').append(Files.getLastModifiedTime(jar));
    }
    return identity.toString();
  }

  @Override
  public Optional<CompiledApplication> openEarly(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    // A package may have to be fetched first.
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
        !compilation.coverage() || recorder == null
            ? null
            : JavaCoverage.of(compilation.application(), recorder, compilation.output())
                .orElse(null);
    return new JavaApplication(
        classPath, compilation.application().entryPoint(), early, archive, recording);
  }

  @Override
  public void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    TestApplication application = compilation.application();
    List<Path> libraries = libraries(compilation);
    List<Path> classPath = new ArrayList<>(runtimeJars);
    classPath.addAll(libraries);
    List<JavaSource> sources = JavaSource.of(application);
    copyResources(application, compilation.output());

    JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    DiagnosticCollection errors = new DiagnosticCollection();
    try (StandardJavaFileManager files =
        javac.getStandardFileManager(errors, Locale.ROOT, StandardCharsets.UTF_8)) {
      files.setLocationFromPaths(StandardLocation.CLASS_PATH, classPath);
      files.setLocationFromPaths(StandardLocation.SOURCE_PATH, List.of());
      files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(compilation.output()));
      AbortableFiles abortable = new AbortableFiles(files);
      ComponentClass component = new ComponentClass(application, libraries);
      await(
          new JavaCompilation(javac, abortable, errors, sources, component),
          abortable,
          compilation.atMost());
    }
    if (!errors.isEmpty()) {
      throw errors.failure();
    }
  }

  private static void await(JavaCompilation compilation, AbortableFiles files, Duration timeLimit)
      throws CompilationException, InterruptedException, IOException {
    FutureTask<Void> task = new FutureTask<>(compilation);
    Thread thread = new Thread(null, task, "sitaf-javac", 16L << 20);
    thread.setDaemon(true);
    thread.start();
    try {
      task.get(timeLimit.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      files.abort();
      throw new CompilationException(
          "the compilation was given up after " + timeLimit.toSeconds() + " s", List.of());
    } catch (InterruptedException e) {
      files.abort();
      throw e;
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof CompilationException failure) {
        throw failure;
      }
      if (cause instanceof IOException failure) {
        throw failure;
      }
      // javac fails by itself on sources made for it, such as very deep expressions.
      throw new CompilationException(
          "the compiler gave up with " + cause + "; simplify the sources", List.of());
    }
  }

  /**
   * The component's own library and the external ones, of which each must be a jar of the activity,
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
      jars.addAll(packages.jars(packageName, compilation));
    }
    return jars;
  }

  static SourceDiagnostic inProfile(String message) {
    return SourceDiagnostic.ofFile("activity/activity.yaml", message);
  }

  private static void copyResources(TestApplication application, Path classes) {
    for (Map.Entry<String, byte[]> entry : JavaSource.resources(application).entrySet()) {
      try {
        Path target = classes.resolve(entry.getKey());
        Files.createDirectories(target.getParent());
        Files.write(target, entry.getValue());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
