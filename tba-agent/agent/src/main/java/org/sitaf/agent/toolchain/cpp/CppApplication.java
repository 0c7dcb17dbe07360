package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;
import org.sitaf.agent.toolchain.sanitizer.SanitizerReport;
import org.sitaf.agent.toolchain.sanitizer.SanitizerSettings;
import org.sitaf.core.verdict.Coverage;

/**
 * A compiled C++ test application.
 *
 * @param folder folder of the program and of the component's libraries, in {@code lib}
 * @param runtime folder of the runtime library
 * @param sanitized whether it is compiled with sanitizers
 * @param recording null if coverage is off
 */
record CppApplication(
    Path folder, String program, Path runtime, boolean sanitized, @Nullable CppCoverage recording)
    implements CompiledApplication {
  /** Last line that the runtime prints when it gets SIGQUIT. */
  private static final String HANG_PREFIX = "hangs in ";

  /** Folder of the coverage notes, one {@code unitN.gcno} per instrumented unit. */
  static final String NOTES = "coverage";

  /** Folder of the component's shared libraries. */
  static final String LIBRARIES = "lib";

  /** File with the compiler's warnings about the user's sources. */
  static final String WARNINGS = "warnings";

  /** Memory of gRPC. */
  private static final int OVERHEAD_MIB = 96;

  @Override
  public List<String> command(ProcessPlace place) {
    return List.of(folder.resolve(program).toString());
  }

  @Override
  public Map<String, String> environment(ProcessPlace place) {
    Map<String, String> environment = new HashMap<>(place.memoryFill());
    environment.putAll(place.debuggerVariables());
    // A library of the component may need another one of its libraries.
    environment.put("LD_LIBRARY_PATH", runtime + ":" + folder.resolve(LIBRARIES));
    Path coverage = place.coverage();
    if (coverage != null) {
      environment.put("GCOV_PREFIX", coverage.toString());
    }
    if (sanitized) {
      environment.putAll(SanitizerSettings.environment(null));
    }
    return environment;
  }

  @Override
  public Debuggee debuggee(DebugPlace place, long pid) {
    return new CppDebuggee(place, pid, folder.resolve(program));
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
  public Optional<String> crashCause(String errors) {
    return sanitized ? SanitizerReport.cause(errors) : Optional.empty();
  }

  @Override
  public List<String> warnings() throws IOException {
    return Files.readAllLines(folder.resolve(WARNINGS));
  }

  @Override
  public boolean reservesMemory() {
    return sanitized;
  }

  @Override
  public int overheadMiB() {
    return sanitized ? OVERHEAD_MIB + SanitizerSettings.MEMORY_MIB : OVERHEAD_MIB;
  }
}
