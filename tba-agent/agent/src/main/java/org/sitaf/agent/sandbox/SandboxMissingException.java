package org.sitaf.agent.sandbox;

import java.io.IOException;

/** No sandbox works on this machine; the message says why and what to install. */
final class SandboxMissingException extends IOException {
  private static final long serialVersionUID = 1L;

  SandboxMissingException(String message) {
    super(message);
  }
}
