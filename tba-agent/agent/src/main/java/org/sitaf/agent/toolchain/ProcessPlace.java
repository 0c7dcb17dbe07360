package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.Objects;

/**
 * Where one process of a test application works.
 *
 * @param directory the executor's own, absolute; only for files that a crash of the runtime leaves
 * @param temporary for temporary files, writable, absolute
 * @param memoryMiB what the profile grants the component
 */
public record ProcessPlace(Path directory, Path temporary, int memoryMiB) {
  public ProcessPlace {
    Objects.requireNonNull(directory);
    Objects.requireNonNull(temporary);
  }
}
