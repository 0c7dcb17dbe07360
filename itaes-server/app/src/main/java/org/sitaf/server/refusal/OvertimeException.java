package org.sitaf.server.refusal;

/** A computation did not end in its time; it was ended. */
public final class OvertimeException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** What took longer than so many seconds. */
  public OvertimeException(String what, long seconds) {
    super(
        what
            + " took longer than "
            + seconds
            + " s and was ended: give the parameters fewer values, lower the strength, or simplify"
            + " the conditions");
  }
}
