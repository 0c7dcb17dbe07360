package org.sitaf.server.storage;

import org.sitaf.server.settings.SitafSettings;

/** The server does not start: the disk is full. */
final class NoRoomToStartException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final String remedy;

  NoRoomToStartException(String why, SitafSettings settings) {
    super("The server does not start: " + why + ".");
    remedy =
        "Make room below %s, and start the server again; sitaf.min-free says"
                .formatted(settings.dataDirectory())
            + " how much is kept free.";
  }

  /** What an operator does about it. */
  String remedy() {
    return remedy;
  }
}
