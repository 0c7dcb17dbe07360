package org.sitaf.core.model;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The method under test.
 *
 * @param interfaceName null if the method is searched in all provided interfaces
 * @param method name of the method; the model's name if the model has no target
 * @param signature parameter types that select an overload, such as {@code int,int}; null if not
 *     overloaded
 * @param settle simulation time between set-up and the call
 * @param runFor simulation time after the call
 */
public record Target(
    @Nullable String interfaceName,
    String method,
    @Nullable String signature,
    Duration settle,
    Duration runFor) {
  public Target {
    Objects.requireNonNull(method);
    if (settle.isNegative() || runFor.isNegative()) {
      throw new IllegalArgumentException("settle and run_for must not be negative");
    }
  }
}
