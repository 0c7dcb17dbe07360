package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.coverage.GcovReport;
import org.sitaf.core.verdict.Coverage;

/**
 * Which lines of a C++ component are reached, by gcov.
 *
 * @param notes what gcov needs of the compilation
 * @param scratch a folder for what nobody needs afterwards, absolute
 * @param sources folder of the component's sources within the activity, with a slash at its end
 */
record CppCoverage(Path notes, Path scratch, Sandbox sandbox, String sources) {
  /** How the compiler knew the folder of the activity. */
  private static final String ACTIVITY = "activity/";

  /**
   * Empty where nobody asks for it, the component has no sources, this machine has no gcov, or the
   * compiler is not one that it understands.
   */
  static Optional<CppCoverage> of(Compilation compilation, Compiler compiler) {
    String sources = compilation.application().activity().profile().component().sources();
    if (!compilation.coverage()
        || sources == null
        || !compiler.isMeasuredByGcov()
        || Tools.find("gcov").isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new CppCoverage(
            compilation.output().resolve(CppApplication.NOTES),
            compilation.scratch().resolve("coverage"),
            compilation.sandbox(),
            CppSources.withSlash(sources)));
  }

  /**
   * Reads what processes have recorded.
   *
   * @param data holds a folder a process
   */
  Coverage read(Path data) throws IOException, InterruptedException {
    return GcovReport.read(data, notes, scratch, sandbox, ACTIVITY, sources);
  }
}
