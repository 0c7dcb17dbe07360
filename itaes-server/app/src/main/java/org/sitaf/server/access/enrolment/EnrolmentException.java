package org.sitaf.server.access.enrolment;

/** An enrolment is rejected; the message says why and what the agent's operator can do. */
public final class EnrolmentException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean nameTaken;

  private EnrolmentException(boolean nameTaken, String message) {
    super(message);
    this.nameTaken = nameTaken;
  }

  static EnrolmentException invalidToken() {
    return new EnrolmentException(
        false, "the enrolment token is unknown, used up, expired, or for another agent");
  }

  static EnrolmentException nameTaken(String name) {
    return new EnrolmentException(
        true,
        "an agent named "
            + name
            + " has a key already; revoke that key, or create an enrolment token for this agent");
  }

  /** Whether an agent of that name has a key already; otherwise the token is invalid. */
  public boolean isNameTaken() {
    return nameTaken;
  }
}
