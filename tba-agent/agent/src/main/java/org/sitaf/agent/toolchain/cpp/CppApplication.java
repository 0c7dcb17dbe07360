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
 * A test application as a program.
 *
 * @param folder holds the program, and the component's libraries in {@code lib}
 * @param runtime folder of the runtime's library
 * @param recording null where nothing is recorded
 */
record CppApplication(Path folder, String program, Path runtime, @Nullable CppCoverage recording)
    implements CompiledApplication {
  /** What the runtime says last when it is asked where it is. */
  private static final String HANGS = "hangs in ";

  /**
   * Folder of what gcov needs of the compilation, one {@code unitN.gcno} for each measured unit.
   */
  static final String NOTES = "coverage";

  /** Folder of the shared libraries that the component brings. */
  static final String LIBRARIES = "lib";

  /** gRPC's own. */
  private static final int OVERHEAD_MIB = 96;

  @Override
  public List<String> command(ProcessPlace place) {
    return List.of(folder.resolve(program).toString());
  }

  @Override
  public Map<String, String> environment(ProcessPlace place) {
    Map<String, String> environment = new HashMap<>();
    // What the component brings may itself need another library of it.
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
  public Optional<String> whereItHangs(String stacks) {
    return stacks
        .lines()
        .filter(line -> line.startsWith(HANGS))
        .map(line -> line.substring(HANGS.length()))
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
