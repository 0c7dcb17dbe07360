package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.core.harness.TestApplication;

/**
 * What a toolchain is asked for.
 *
 * @param sources where the application's files lie, in the layout of {@link TestApplication};
 *     absolute, not to be written
 * @param output an empty folder for what is compiled, absolute; may be moved when it is complete,
 *     so nothing in it may hold its own path; a process that was started early may see it already,
 *     so that the folder itself stays
 * @param scratch a folder for what nobody needs afterwards, absolute
 * @param atMost a compilation that takes longer is given up
 * @param coverage whether processes are to record which lines of the component they reach
 * @param sandbox in which tools run
 */
public record Compilation(
    TestApplication application,
    Path sources,
    Path output,
    Path scratch,
    Duration atMost,
    boolean coverage,
    Sandbox sandbox) {
  public Compilation {
    Objects.requireNonNull(application);
    Objects.requireNonNull(sources);
    Objects.requireNonNull(output);
    Objects.requireNonNull(scratch);
    Objects.requireNonNull(atMost);
    Objects.requireNonNull(sandbox);
  }

  /** Where the user's activity lies. */
  public Path activity() {
    return sources.resolve("activity");
  }

  /** Where the generated sources lie. */
  public Path harness() {
    return sources.resolve("harness");
  }
}
