package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.coverage.GcovReport;
import org.sitaf.core.verdict.Coverage;

/**
 * Line coverage of a C++ node, measured by gcov.
 *
 * @param notes folder of the coverage notes of its compilation
 * @param scratch absolute folder for temporary files
 * @param sources folder of the component's sources in the activity, with a trailing slash
 */
record NodeCoverage(Path notes, Path scratch, Sandbox sandbox, String sources)
    implements Recording {
  @Override
  public Map<String, String> environment(Path directory) {
    return Map.of("GCOV_PREFIX", directory.toString());
  }

  @Override
  public Coverage read(Path data) throws IOException, InterruptedException {
    return GcovReport.read(data, notes, scratch, sandbox, CppNodes.ACTIVITY, sources);
  }
}
