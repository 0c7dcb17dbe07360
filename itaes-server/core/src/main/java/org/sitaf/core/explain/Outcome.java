package org.sitaf.core.explain;

import java.util.Objects;

/**
 * What an execution of a case gave.
 *
 * @param failed whether the verdict is FAIL or ERROR
 * @param kind verdict and message without what differs between cases; empty if it passed
 */
public record Outcome(boolean failed, String kind) {
  /** The outcome of a case that passed. */
  public static final Outcome PASSED = new Outcome(false, "");

  public Outcome {
    Objects.requireNonNull(kind);
  }
}
