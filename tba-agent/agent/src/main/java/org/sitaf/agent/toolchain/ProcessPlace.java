package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.debug.DebugPlace;

/**
 * Folders and memory of one process of a test application.
 *
 * @param temporary absolute, writable folder for temporary files
 * @param coverage absolute, writable folder for the coverage data of this process only; null if
 *     coverage is off
 * @param memoryMiB memory limit of the component
 * @param variation changes what the results of a correct component do not depend on, as far as the
 *     language allows it: the order of hashes and the content of allocated memory; 0 for the
 *     defaults
 * @param debugging where the process waits for a debugger; null if it does not wait
 */
public record ProcessPlace(
    Path temporary,
    @Nullable Path coverage,
    int memoryMiB,
    int variation,
    @Nullable DebugPlace debugging) {
  private static final int BYTE_VALUES = 255;

  public ProcessPlace {
    Objects.requireNonNull(temporary);
    if (variation < 0) {
      throw new IllegalArgumentException("variation must be at least 0, not " + variation);
    }
  }

  /** A place of a process that is not debugged. */
  public ProcessPlace(Path temporary, @Nullable Path coverage, int memoryMiB, int variation) {
    this(temporary, coverage, memoryMiB, variation, null);
  }

  /** Environment variables that let a runtime wait for a debugger; may be empty. */
  public Map<String, String> debuggerVariables() {
    if (debugging == null) {
      return Map.of();
    }
    String folder = debugging.folder().toString();
    return debugging.order().inTerminal()
        ? Map.of(DebugPlace.VARIABLE, folder)
        : Map.of(DebugPlace.VARIABLE, folder, DebugPlace.PORT, Integer.toString(debugging.port()));
  }

  /** Environment variables that let the C library fill memory that it allocates; may be empty. */
  public Map<String, String> memoryFill() {
    return variation == 0
        ? Map.of()
        : Map.of("MALLOC_PERTURB_", Integer.toString(1 + variation % BYTE_VALUES));
  }
}
