package org.sitaf.server.git.remote;

/** A repository could not be fetched. The message says what happened and what to do. */
public final class RemoteException extends Exception {
  private static final long serialVersionUID = 1L;

  RemoteException(String message, Throwable cause) {
    super(message, cause);
  }

  public RemoteException(String message) {
    super(message);
  }

  /** The message, which is never null. */
  public String text() {
    return String.valueOf(getMessage());
  }
}
