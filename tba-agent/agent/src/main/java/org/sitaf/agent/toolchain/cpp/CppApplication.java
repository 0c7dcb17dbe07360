package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.core.verdict.Coverage;

/**
 * A compiled C++ test application.
 *
 * @param folder folder of the program and of the component's libraries, in {@code lib}
 * @param runtime folder of the runtime library
 * @param recording null if coverage is off
 */
record CppApplication(Path folder, String program, Path runtime, @Nullable CppCoverage recording)
    implements CompiledApplication {
  /** Last line that the runtime prints when it gets SIGQUIT. */
  private static final String HANG_PREFIX = "hangs in ";

  /** Folder of the coverage notes, one {@code unitN.gcno} per instrumented unit. */
  static final String NOTES = "coverage";

  /** Folder of the component's shared libraries. */
  static final String LIBRARIES = "lib";

  /** Memory of gRPC. */
  private static final int OVERHEAD_MIB = 96;

  @Override
  public List<String> command(ProcessPlace place) {
    return List.of(folder.resolve(program).toString());
  }

  @Override
  public Map<String, String> environment(ProcessPlace place) {
    Map<String, String> environment = new HashMap<>();
    // A library of the component may need another one of its libraries.
    environment.put("LD_LIBRARY_PATH", runtime + ":" + folder.resolve(LIBRARIES));
    Path coverage = place.coverage();
    if (coverage != null) {
      environment.put("GCOV_PREFIX", coverage.toString());
    }
    return environment;
  }

  @Override
  public List<Path> readable() {
    return List.of(folder, runtime);
  }

  @Override
  public Optional<String> hangLocation(String stacks) {
    return stacks
        .lines()
        .filter(line -> line.startsWith(HANG_PREFIX))
        .map(line -> line.substring(HANG_PREFIX.length()))
        .findFirst();
  }

  @Override
  public boolean recordsCoverage() {
    return recording != null;
  }

  @Override
  public Optional<Coverage> coverage(Path data) throws IOException, InterruptedException {
    return recording == null ? Optional.empty() : Optional.of(recording.read(data));
  }

  @Override
  public int overheadMiB() {
    return OVERHEAD_MIB;
  }
}
