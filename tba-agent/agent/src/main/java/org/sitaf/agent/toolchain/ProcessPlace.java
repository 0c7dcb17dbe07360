package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Folders and memory of one process of a test application.
 *
 * @param temporary absolute, writable folder for temporary files
 * @param coverage absolute, writable folder for the coverage data of this process only; null if
 *     coverage is off
 * @param memoryMiB memory limit of the component
 */
public record ProcessPlace(Path temporary, @Nullable Path coverage, int memoryMiB) {
  public ProcessPlace {
    Objects.requireNonNull(temporary);
  }
}
