package org.sitaf.server.storage;

import java.sql.SQLException;

/** A statement was not even given to the database: there is no room for what it would write. */
final class NoRoomException extends SQLException {
  private static final long serialVersionUID = 1L;

  /** As PostgreSQL says it (class 53, insufficient resources). */
  static final String DISK_FULL = "53100";

  NoRoomException(String why) {
    super(why, DISK_FULL);
  }
}
