package org.sitaf.server.storage;

import java.sql.SQLException;

/** A statement was not sent to the database because the disk is full. */
final class DiskFullException extends SQLException {
  private static final long serialVersionUID = 1L;

  /** PostgreSQL's error code (class 53, insufficient resources). */
  static final String DISK_FULL = "53100";

  DiskFullException(String why) {
    super(why, DISK_FULL);
  }
}
