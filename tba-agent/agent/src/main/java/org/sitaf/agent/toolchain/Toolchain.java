package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Language;

/** A language that this machine can compile and run. Thread-safe. */
public interface Toolchain {
  Language language();

  /** Version of the compiler or interpreter, such as {@code javac 17.0.15}. */
  String version();

  /** The compiler or interpreter with the options for an activity's sources. */
  default String compiler(ActivityProfile profile) {
    return version();
  }

  /**
   * Everything except the sources that determines the result of {@link #compile}: compiler,
   * options, runtime. Results of another identity are never reused.
   */
  String identity() throws IOException, InterruptedException;

  /** Why its processes cannot be debugged on this machine, and what to do; empty if they can. */
  default Optional<String> missingDebugger() {
    return Optional.empty();
  }

  /**
   * Makes what this machine needs once before {@link #identity} is known, and reports that to the
   * compilation's listener.
   */
  default void prepare(Compilation compilation) throws IOException, InterruptedException {}

  /** Starts a process ahead for the next compilation; it runs no code of users. */
  default void startAhead(Sandbox sandbox) throws IOException, InterruptedException {}

  /** Ends the processes that were started ahead. */
  default void stop() {}

  /**
   * Whether {@link #compile} may read a file of the activity outside of the folders that the
   * profile names for the component. By default every file if there are libraries, since a library
   * may refer to other files.
   */
  default boolean readsElsewhere(String path, ActivityProfile profile) {
    return profile.component().library() != null || !profile.libraries().isEmpty();
  }

  /**
   * Whether an earlier result of {@link #compile} is still valid, given the files of this machine
   * that {@link #identity} does not cover.
   *
   * @param compiled the earlier output folder, or a copy of it
   */
  default boolean isCurrent(Compilation compilation, Path compiled) throws IOException {
    return true;
  }

  /**
   * Compiles component, adapter and harness. Not called if a valid result is cached; then the
   * output folder holds that result.
   *
   * @throws CompilationException if the user's files have errors
   * @throws InterruptedException if the build was cancelled
   * @throws IOException if this machine fails
   */
  void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException;

  /**
   * The command for a process that starts before the application is compiled and waits for a line
   * on its input; the arguments of a test application are appended. Empty if nothing can start
   * without the compiled files.
   */
  default Optional<CompiledApplication> openEarly(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    return Optional.empty();
  }

  /**
   * The command that starts the application from the output folder. Also downloads packages that it
   * needs at run time. Called for each build, after {@link #compile} or instead of it.
   */
  CompiledApplication open(Compilation compilation)
      throws CompilationException, InterruptedException, IOException;
}
