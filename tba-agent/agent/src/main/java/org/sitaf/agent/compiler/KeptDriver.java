package org.sitaf.agent.compiler;

import java.util.List;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;

/**
 * A concrete test driver that is part of the activity. It is never overwritten, so it may be
 * outdated after a change of the interface.
 */
final class KeptDriver {
  private static final String SINCE =
      " (the interface may have changed since this file was kept; ./sitaf harness ACTIVITY_DIR"
          + " shows the one that is generated now)";

  private KeptDriver() {}

  /** Adds the likely cause to errors in a kept driver. */
  static CompilationException explained(CompilationException found, TestApplication application) {
    String kept =
        "activity/"
            + InterfaceTestApplicationGenerator.keptDriver(
                application.activity(), application.model());
    if (found.diagnostics().stream().noneMatch(d -> d.file().equals(kept))) {
      return found;
    }
    List<SourceDiagnostic> explained =
        found.diagnostics().stream()
            .map(
                d ->
                    d.file().equals(kept)
                        ? new SourceDiagnostic(
                            d.file(), d.line(), d.column(), d.message() + SINCE, d.generated())
                        : d)
            .toList();
    CompilationException exception = new CompilationException(found.getMessage(), explained);
    exception.addSuppressed(found);
    return exception;
  }
}
