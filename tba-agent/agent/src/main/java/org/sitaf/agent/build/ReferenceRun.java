package org.sitaf.agent.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.ReferenceValues;

/**
 * Executes the cases of a build with the reference implementation, before the component under test.
 * The two never run at the same time and share no files.
 *
 * @param application with the files of the reference
 * @param directory for the files of the run
 */
record ReferenceRun(TestApplication application, Path directory, BuildSettings settings) {
  /**
   * The suite with the outputs of the reference as expected values where it has none.
   *
   * @throws CompilationException if the reference does not compile
   * @throws IOException if it cannot be executed
   */
  TestSuite suite(BuildLog log) throws CompilationException, IOException, InterruptedException {
    log.remark("executing the reference " + className());
    Files.createDirectories(directory);
    List<CaseRecord> records = Collections.synchronizedList(new ArrayList<>());
    BuildSettings plain =
        new BuildSettings(
                settings.simulator(),
                settings.toolchains(),
                settings.sandbox(),
                false,
                settings.agent())
            .within(settings.atMost());
    BuildOutcome outcome =
        new BuildRun(
                InterfaceTestApplicationGenerator.ofReference(application),
                directory,
                plain,
                new QuietBuild(),
                records::add)
            .stages(log);
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      throw new CompilationException("reference: " + failed.message(), failed.diagnostics());
    }
    if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
      throw new IOException("the reference cannot be executed: " + failed.message());
    }
    log.remark("executing the component");
    return ReferenceValues.added(application.model(), application.suite(), List.copyOf(records));
  }

  private String className() {
    var reference = application.activity().profile().reference();
    return reference == null ? "" : reference.className();
  }
}
