package org.sitaf.agent.sandbox;

import java.io.IOException;

/** This machine has no sandbox that works; the message says why and what installs it. */
final class SandboxMissingException extends IOException {
  private static final long serialVersionUID = 1L;

  SandboxMissingException(String message) {
    super(message);
  }
}
