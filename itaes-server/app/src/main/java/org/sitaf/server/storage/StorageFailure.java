package org.sitaf.server.storage;

import java.io.IOException;
import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.util.Optional;
import java.util.Set;

/** Temporary failures of the server's storage. */
public enum StorageFailure {
  /** A disk is full, or a disk quota is exceeded. */
  DISK_FULL,
  /** The database cannot be reached, or is being reopened. */
  DATABASE_UNAVAILABLE;

  private static final int MAX_CAUSES = 30;

  /** H2's error codes: the database is closed or closing, or its file is still in use. */
  private static final Set<Integer> CLOSED = Set.of(90098, 90121, 90020);

  private static final int GENERAL_ERROR = 50000;

  /** Returns the storage failure that caused an exception, if any. */
  public static Optional<StorageFailure> of(Throwable failure) {
    Optional<StorageFailure> found = Optional.empty();
    Throwable cause = failure;
    for (int depth = 0; cause != null && depth < MAX_CAUSES; depth++) {
      if (isDiskFull(cause)) {
        return Optional.of(DISK_FULL);
      }
      if (isUnavailable(cause)) {
        found = Optional.of(DATABASE_UNAVAILABLE);
      }
      cause = cause.getCause();
    }
    return found;
  }

  private static boolean isDiskFull(Throwable cause) {
    String message = String.valueOf(cause.getMessage());
    return cause instanceof SQLException sql
        ? DiskFullException.DISK_FULL.equals(sql.getSQLState())
        : cause instanceof IOException
            && (message.contains("No space left on device")
                || message.contains("Disk quota exceeded"));
  }

  private static boolean isUnavailable(Throwable cause) {
    return cause instanceof SQLTransientConnectionException
        || (cause instanceof SQLException sql
            && (String.valueOf(sql.getSQLState()).startsWith("08") || isClosedH2(sql)));
  }

  /** Whether H2 closed the database, which it does for all connections when a write fails. */
  static boolean isClosedH2(SQLException e) {
    return CLOSED.contains(e.getErrorCode())
        || (e.getErrorCode() == GENERAL_ERROR
            && String.valueOf(e.getMessage()).contains("MVStoreException"));
  }
}
