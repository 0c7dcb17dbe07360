package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.function.Consumer;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.core.harness.TestApplication;

/**
 * Input of a toolchain.
 *
 * @param sources absolute folder of the application's files, in the layout of {@link
 *     TestApplication}; read-only
 * @param output absolute, empty folder for the result. The folder may be moved when it is complete,
 *     so no file in it may contain its path. A process that was started early may already see it,
 *     so it must not be replaced
 * @param scratch absolute folder for temporary files
 * @param atMost timeout of the compilation
 * @param coverage whether processes record which lines of the component they execute
 * @param debugging whether the code is compiled for a debugger: without optimization
 * @param sandbox in which tools run
 * @param progress receives what a long compilation does, for people; called from any thread
 */
public record Compilation(
    TestApplication application,
    Path sources,
    Path output,
    Path scratch,
    Duration atMost,
    boolean coverage,
    boolean debugging,
    Sandbox sandbox,
    Consumer<String> progress) {
  public Compilation {
    Objects.requireNonNull(application);
    Objects.requireNonNull(sources);
    Objects.requireNonNull(output);
    Objects.requireNonNull(scratch);
    Objects.requireNonNull(atMost);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(progress);
  }

  /** A compilation whose progress nobody follows. */
  public Compilation(
      TestApplication application,
      Path sources,
      Path output,
      Path scratch,
      Duration atMost,
      boolean coverage,
      boolean debugging,
      Sandbox sandbox) {
    this(
        application,
        sources,
        output,
        scratch,
        atMost,
        coverage,
        debugging,
        sandbox,
        progress -> {});
  }

  /** A compilation that is not for a debugger. */
  public Compilation(
      TestApplication application,
      Path sources,
      Path output,
      Path scratch,
      Duration atMost,
      boolean coverage,
      Sandbox sandbox) {
    this(application, sources, output, scratch, atMost, coverage, false, sandbox);
  }

  /** The same compilation with a listener for its progress. */
  public Compilation reporting(Consumer<String> listener) {
    return new Compilation(
        application, sources, output, scratch, atMost, coverage, debugging, sandbox, listener);
  }

  /** The folder of the user's activity. */
  public Path activity() {
    return sources.resolve("activity");
  }

  /** The folder of the generated sources. */
  public Path harness() {
    return sources.resolve("harness");
  }
}
