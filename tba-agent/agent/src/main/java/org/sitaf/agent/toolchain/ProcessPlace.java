package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Where one process of a test application works.
 *
 * @param temporary for temporary files, writable, absolute
 * @param coverage for what the process records of the lines that it reaches, writable, absolute, of
 *     this process alone; null where nobody wants to know
 * @param memoryMiB what the profile grants the component
 */
public record ProcessPlace(Path temporary, @Nullable Path coverage, int memoryMiB) {
  public ProcessPlace {
    Objects.requireNonNull(temporary);
  }
}
