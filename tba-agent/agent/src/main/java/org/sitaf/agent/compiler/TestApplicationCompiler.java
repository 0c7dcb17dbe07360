package org.sitaf.agent.compiler;

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
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.harness.TestApplication;

/**
 * Compiles Java test applications in this process, without annotation processors: no code of the
 * user runs while it is compiled.
 *
 * @param runtimeJars what a test application links against
 * @param timeLimit a compilation that takes longer is given up
 */
public record TestApplicationCompiler(List<Path> runtimeJars, Duration timeLimit) {
  public TestApplicationCompiler {
    runtimeJars = List.copyOf(runtimeJars);
    Objects.requireNonNull(timeLimit);
  }

  /**
   * Compiles component, adapter and harness into one folder.
   *
   * @param applicationDirectory where the application's files lie
   * @param classes where the classes go; created
   * @throws CompilationException when the user's files are at fault
   * @throws InterruptedException when the build was cancelled meanwhile
   * @throws IOException when the agent's disk is at fault
   */
  public CompiledApplication compile(
      TestApplication application, Path applicationDirectory, Path classes)
      throws CompilationException, InterruptedException, IOException {
    List<Path> classPath = new ArrayList<>(runtimeJars);
    List<Path> libraries = libraries(application, applicationDirectory.resolve("activity"));
    classPath.addAll(libraries);
    List<JavaSource> sources = JavaSource.of(application);
    Files.createDirectories(classes);
    copyResources(application, classes);

    JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    if (javac == null) {
      throw new IOException("this Java has no compiler: " + System.getProperty("java.home"));
    }
    DiagnosticCollection errors = new DiagnosticCollection();
    try (StandardJavaFileManager files =
        javac.getStandardFileManager(errors, Locale.ROOT, StandardCharsets.UTF_8)) {
      files.setLocationFromPaths(StandardLocation.CLASS_PATH, classPath);
      files.setLocationFromPaths(StandardLocation.SOURCE_PATH, List.of());
      files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(classes));
      AbortableFiles abortable = new AbortableFiles(files);
      ComponentClass component = new ComponentClass(application, libraries);
      JavaCompilation compilation =
          new JavaCompilation(javac, abortable, errors, sources, component);
      await(compilation, abortable);
    }
    if (!errors.isEmpty()) {
      throw errors.failure();
    }
    classPath.add(classes);
    return new CompiledApplication(classPath, application.mainClass());
  }

  private void await(JavaCompilation compilation, AbortableFiles files)
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

  /** The component's own library and the external ones; each must be a jar of the activity. */
  private static List<Path> libraries(TestApplication application, Path activityDirectory)
      throws CompilationException {
    ActivityProfile profile = application.activity().profile();
    List<SourceDiagnostic> problems = new ArrayList<>();
    List<Path> jars = new ArrayList<>();
    if (profile.component().packageName() != null) {
      problems.add(
          inProfile(
              "component: package: "
                  + profile.component().packageName()
                  + ": this agent cannot fetch Java packages; give 'sources:' or a .jar as"
                  + " 'library:'"));
    }
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
        jars.add(activityDirectory.resolve(library));
      }
    }
    if (!problems.isEmpty()) {
      throw new CompilationException("the component's libraries cannot be used", problems);
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
