package org.sitaf.server.access.web;

/** The server does not start because it would listen on other interfaces without TLS. */
final class InsecureTransportException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final String remedy;

  InsecureTransportException(String message, String remedy) {
    super(message);
    this.remedy = remedy;
  }

  /** How the operator can fix it. */
  String remedy() {
    return remedy;
  }
}
