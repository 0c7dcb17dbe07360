package org.sitaf.server.storage;

import java.sql.SQLException;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/**
 * Reports that another server uses the same data directory, without a stack trace; registered in
 * {@code META-INF/spring.factories}.
 */
final class DatabaseInUseAnalyzer extends AbstractFailureAnalyzer<SQLException> {
  /** H2's DATABASE_ALREADY_OPEN_1. */
  private static final int ALREADY_OPEN = 90020;

  @Override
  protected @Nullable FailureAnalysis analyze(Throwable root, SQLException cause) {
    return cause.getErrorCode() == ALREADY_OPEN
        ? new FailureAnalysis(
            "The server does not start: another server uses the same data directory.",
            "Stop the other server, or set another folder with --sitaf.data-directory.",
            cause)
        : null;
  }
}
