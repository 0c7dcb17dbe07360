package org.sitaf.core.campaign;

/** What a component does while devices fail, from best to worst. */
public enum Behaviour {
  UNCHANGED("unchanged"),
  RECOVERED("degraded and recovered"),
  STOPPED("stopped safely"),
  BROKEN("broke a condition"),
  CRASHED("crashed");

  private final String text;

  Behaviour(String text) {
    this.text = text;
  }

  /** The words in tables. */
  public String text() {
    return text;
  }

  /** Whether the component does not cope with the fault. */
  public boolean isFailure() {
    return this == BROKEN || this == CRASHED;
  }
}
