package org.sitaf.server.access.enrolment;

/** An agent is not let in; the message says why, and what its operator does. */
public final class EnrolmentRefused extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Whether the name of the agent is taken, rather than its token wrong. */
  private final boolean nameTaken;

  private EnrolmentRefused(boolean nameTaken, String message) {
    super(message);
    this.nameTaken = nameTaken;
  }

  static EnrolmentRefused wrongToken() {
    return new EnrolmentRefused(
        false, "the enrolment token is unknown, used up, expired, or for another agent");
  }

  static EnrolmentRefused nameTaken(String name) {
    return new EnrolmentRefused(
        true,
        "an agent named "
            + name
            + " has a key already; revoke that, or make an enrolment token for this agent");
  }

  /** Whether the name of the agent is taken, rather than its token wrong. */
  public boolean isNameTaken() {
    return nameTaken;
  }
}
