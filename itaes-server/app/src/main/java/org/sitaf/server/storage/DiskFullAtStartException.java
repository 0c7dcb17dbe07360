package org.sitaf.server.storage;

import org.sitaf.server.settings.SitafSettings;

/** The server does not start because the disk is full. */
final class DiskFullAtStartException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final String remedy;

  DiskFullAtStartException(String why, SitafSettings settings) {
    super("The server does not start: " + why + ".");
    remedy =
        "Free space on the disk of %s and start the server again; sitaf.min-free is the space that"
                .formatted(settings.dataDirectory())
            + " must be free.";
  }

  /** How the operator can fix it. */
  String remedy() {
    return remedy;
  }
}
