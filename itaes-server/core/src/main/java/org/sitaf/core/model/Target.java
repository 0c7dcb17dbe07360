package org.sitaf.core.model;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The method under test.
 *
 * @param interfaceName null where any provided interface may hold the method
 * @param method name of the method; the model's name where the model has no target
 * @param signature parameter types of an overload, such as {@code int,int}; null where the name
 *     alone decides
 * @param settle simulation time that passes before the call
 * @param runFor simulation time that passes after the call
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
