package org.sitaf.agent.compiler;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.harness.TestApplication;

/**
 * Compiles test applications with the toolchain of their language, or takes them from a cache.
 *
 * @param cache may be shared by several builds and processes
 * @param coverage whether processes measure line coverage
 * @param debugging whether the code is compiled for a debugger
 * @param sandbox for the tools of the toolchain
 */
public record TestApplicationCompiler(
    Toolchain toolchain, Path cache, boolean coverage, boolean debugging, Sandbox sandbox) {
  private static final long CACHE_BYTES = 1L << 30;
  private static final Duration LIMIT = Duration.ofMinutes(2);

  /** A compiler whose results are not debugged. */
  public TestApplicationCompiler(
      Toolchain toolchain, Path cache, boolean coverage, Sandbox sandbox) {
    this(toolchain, cache, coverage, false, sandbox);
  }

  /**
   * Prepares a compilation.
   *
   * @param sources folder of the application's files
   * @param directory output folder; created if missing
   */
  public Compilation begin(TestApplication application, Path sources, Path directory)
      throws IOException {
    return new Compilation(
        application,
        sources,
        Files.createDirectories(directory.resolve("compiled")),
        Files.createDirectories(directory.resolve("scratch")),
        LIMIT,
        coverage,
        debugging,
        sandbox);
  }

  /**
   * The packages of an application, in ascending order; downloads those that are missing. Compiles
   * nothing.
   *
   * @param directory for temporary files; created if missing
   * @throws CompilationException if packages cannot be downloaded, or are not those of the lock
   */
  public List<ResolvedPackage> packages(TestApplication application, Path directory)
      throws CompilationException, InterruptedException, IOException {
    Path sources = directory.resolve("sources");
    FileTree files = application.activity().files();
    for (String path : files.paths()) {
      Path file = sources.resolve("activity").resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, files.content(path).orElseThrow());
    }
    return toolchain.open(begin(application, sources, directory)).packages();
  }

  /**
   * Compiles an application.
   *
   * @throws CompilationException if the user's files have errors
   * @throws InterruptedException if the build was cancelled
   * @throws IOException if this machine fails
   */
  public CompiledApplication compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    TestApplication application = compilation.application();
    toolchain.prepare(compilation);
    CompileCache compiled = new CompileCache(new SharedCache(cache), CACHE_BYTES);
    String key = CompileKey.of(application, toolchain, coverage, debugging);
    CompileCache.Check check = folder -> toolchain.isCurrent(compilation, folder);
    if (!compiled.restore(key, compilation.output(), check)) {
      try {
        toolchain.compile(compilation);
      } catch (CompilationException e) {
        throw KeptDriver.explained(e, application);
      }
      if (check.isCurrent(compilation.output())) {
        compiled.keep(key, compilation.output());
      }
    }
    return toolchain.open(compilation);
  }
}
