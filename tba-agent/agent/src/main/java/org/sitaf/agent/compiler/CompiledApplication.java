package org.sitaf.agent.compiler;

import java.nio.file.Path;
import java.util.List;

/**
 * A test application that can be started.
 *
 * @param classPath runtime, libraries, and last the folder of classes; absolute
 */
public record CompiledApplication(List<Path> classPath, String mainClass) {
  public CompiledApplication {
    classPath = List.copyOf(classPath);
  }
}
