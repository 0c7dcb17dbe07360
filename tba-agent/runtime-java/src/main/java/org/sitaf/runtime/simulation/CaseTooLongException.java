package org.sitaf.runtime.simulation;

import java.math.BigDecimal;
import java.time.Duration;

/** A case lets more simulation time pass than it may. */
public final class CaseTooLongException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CaseTooLongException(Duration most) {
    super(
        "the case took more than "
            + BigDecimal.valueOf(most.toNanos(), 9).stripTrailingZeros().toPlainString()
            + " s of simulation time");
  }
}
