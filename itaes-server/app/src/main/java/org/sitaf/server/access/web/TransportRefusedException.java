package org.sitaf.server.access.web;

/** The server does not start: it would speak without TLS where others listen. */
final class TransportRefusedException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final String remedy;

  TransportRefusedException(String message, String remedy) {
    super(message);
    this.remedy = remedy;
  }

  /** What an operator does about it. */
  String remedy() {
    return remedy;
  }
}
