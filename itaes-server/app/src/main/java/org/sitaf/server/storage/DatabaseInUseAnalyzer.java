package org.sitaf.server.storage;

import java.sql.SQLException;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/**
 * A second server with the data of one that runs says so in a sentence; named in {@code
 * META-INF/spring.factories}.
 */
final class DatabaseInUseAnalyzer extends AbstractFailureAnalyzer<SQLException> {
  /** H2's DATABASE_ALREADY_OPEN_1. */
  private static final int ALREADY_OPEN = 90020;

  @Override
  protected @Nullable FailureAnalysis analyze(Throwable root, SQLException cause) {
    return cause.getErrorCode() == ALREADY_OPEN
        ? new FailureAnalysis(
            "The server does not start: another one works with the same data directory.",
            "Stop that one, or give this one another folder by --sitaf.data-directory.",
            cause)
        : null;
  }
}
