package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.core.activity.ActivityProfile.Language;

/** A language that this machine can compile and run. Safe to use from several threads. */
public interface Toolchain {
  Language language();

  /** Of the compiler or interpreter, such as {@code javac 17.0.15}. */
  String version();

  /**
   * Whatever decides, beside the sources, what {@link #compile} brings: compiler, options, runtime.
   * What was compiled under another identity is never used.
   */
  String identity() throws IOException, InterruptedException;

  /** Starts what the next compilation would wait for otherwise; nothing of a user's is in it. */
  default void startAhead(Sandbox sandbox) throws IOException, InterruptedException {}

  /** Ends what was started ahead. */
  default void stop() {}

  /**
   * Whether {@link #compile} may read any file of the activity, not only those that the profile
   * names for the component.
   */
  default boolean readsWholeActivity() {
    return false;
  }

  /**
   * Whether what {@link #compile} has left in a folder is what it would bring now, as far as files
   * of this machine decide that {@link #identity} does not stand for.
   *
   * @param compiled the output folder, or a copy of it
   */
  default boolean isCurrent(Compilation compilation, Path compiled) throws IOException {
    return true;
  }

  /**
   * Compiles component, adapter and harness. Is not called when the same was compiled before; then
   * the output folder holds already what an earlier call has left there.
   *
   * @throws CompilationException when the user's files are at fault
   * @throws InterruptedException when the build was cancelled meanwhile
   * @throws IOException when this machine is at fault
   */
  void compile(Compilation compilation)
      throws CompilationException, InterruptedException, IOException;

  /**
   * What starts a process of the application before it is compiled, which waits for a line on its
   * input until it is; the arguments of a test application are appended here too. Empty where
   * nothing can be started without what the compiler brings.
   */
  default Optional<CompiledApplication> openEarly(Compilation compilation)
      throws CompilationException, InterruptedException, IOException {
    return Optional.empty();
  }

  /**
   * What starts the application out of the output folder; also fetches packages that it needs at
   * run time. Called for each build, after {@link #compile} or instead of it.
   */
  CompiledApplication open(Compilation compilation)
      throws CompilationException, InterruptedException, IOException;
}
