package org.sitaf.runtime.simulation;

import java.math.BigDecimal;
import java.time.Duration;

/** A case exceeded its limit of simulation time. */
public final class CaseTooLongException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CaseTooLongException(Duration limit) {
    super(
        "the case took more than "
            + BigDecimal.valueOf(limit.toNanos(), 9).stripTrailingZeros().toPlainString()
            + " s of simulation time");
  }
}
