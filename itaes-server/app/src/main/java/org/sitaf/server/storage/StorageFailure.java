package org.sitaf.server.storage;

import java.io.IOException;
import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.util.Optional;
import java.util.Set;

/** Failures of what the server keeps things in, which pass. */
public enum StorageFailure {
  /** A disk or quota is used up. */
  NO_ROOM,
  /** The database cannot be reached, or is being opened anew. */
  DATABASE_AWAY;

  private static final int DEEPEST = 30;

  /**
   * Of H2: the database has been closed, or is at this moment; the file is in use, by what has not
   * let go of it yet.
   */
  private static final Set<Integer> CLOSED = Set.of(90098, 90121, 90020);

  private static final int GENERAL_ERROR = 50000;

  /** What lies behind an exception, if it is one of these. */
  public static Optional<StorageFailure> of(Throwable failure) {
    Optional<StorageFailure> found = Optional.empty();
    Throwable cause = failure;
    for (int depth = 0; cause != null && depth < DEEPEST; depth++) {
      if (isNoRoom(cause)) {
        return Optional.of(NO_ROOM);
      }
      if (isAway(cause)) {
        found = Optional.of(DATABASE_AWAY);
      }
      cause = cause.getCause();
    }
    return found;
  }

  private static boolean isNoRoom(Throwable cause) {
    String message = String.valueOf(cause.getMessage());
    return cause instanceof SQLException sql
        ? NoRoomException.DISK_FULL.equals(sql.getSQLState())
        : cause instanceof IOException
            && (message.contains("No space left on device")
                || message.contains("Disk quota exceeded"));
  }

  private static boolean isAway(Throwable cause) {
    return cause instanceof SQLTransientConnectionException
        || (cause instanceof SQLException sql
            && (String.valueOf(sql.getSQLState()).startsWith("08") || isClosedH2(sql)));
  }

  /** H2 closes a database whose file it could not write, for all who have a connection. */
  static boolean isClosedH2(SQLException e) {
    return CLOSED.contains(e.getErrorCode())
        || (e.getErrorCode() == GENERAL_ERROR
            && String.valueOf(e.getMessage()).contains("MVStoreException"));
  }
}
