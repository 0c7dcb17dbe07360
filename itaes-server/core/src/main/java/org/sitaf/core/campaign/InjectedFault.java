package org.sitaf.core.campaign;

import java.util.Objects;
import org.sitaf.core.description.fault.FaultName;

/**
 * A fault with its value and times.
 *
 * @param name of the fault itself
 * @param beginSeconds after the call
 * @param lengthSeconds infinite if it lasts to the end of the case
 */
public record InjectedFault(
    FaultName name, double value, double beginSeconds, double lengthSeconds) {
  public InjectedFault {
    Objects.requireNonNull(name);
    if (name.part() != FaultName.Part.FAULT) {
      throw new IllegalArgumentException(name.text() + " is a part of a fault");
    }
  }

  /** Whether it ends before the case. */
  public boolean isTransient() {
    return !Double.isInfinite(lengthSeconds);
  }

  /** The fault for messages: {@code fault.ir1.offset = 0.5 from 1 s for 2 s}. */
  public String text() {
    return name.text()
        + (name.kind().isSwitch() ? "" : " = " + number(value))
        + " from "
        + number(beginSeconds)
        + " s"
        + (isTransient() ? " for " + number(lengthSeconds) + " s" : "");
  }

  private static String number(double value) {
    return java.math.BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }
}
