package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.coverage.GcovReport;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.verdict.Coverage;

/**
 * Line coverage of a C++ component, measured by gcov.
 *
 * @param notes folder of the coverage notes
 * @param scratch absolute folder for temporary files
 * @param sources folder of the component's sources in the activity, with a trailing slash
 */
record CppCoverage(Path notes, Path scratch, Sandbox sandbox, String sources) {
  /** Prefix of the activity's paths in the report. */
  private static final String ACTIVITY = "activity/";

  /**
   * Empty if coverage is off, the component has no sources that SITAF compiles, gcov is not
   * installed, or it does not support the compiler.
   */
  static Optional<CppCoverage> of(Compilation compilation, Compiler compiler) {
    Component component = compilation.application().activity().profile().component();
    String sources = component.sources();
    if (!compilation.coverage()
        || sources == null
        || component.cpp().cmake() != null
        || !compiler.isMeasuredByGcov()
        || Tools.find("gcov").isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new CppCoverage(
            compilation.output().resolve(CppApplication.NOTES),
            compilation.scratch().resolve("coverage"),
            compilation.sandbox(),
            CppSources.withTrailingSlash(sources)));
  }

  /**
   * Reads the recorded data.
   *
   * @param data holds one folder per process
   */
  Coverage read(Path data) throws IOException, InterruptedException {
    return GcovReport.read(data, notes, scratch, sandbox, ACTIVITY, sources);
  }
}
