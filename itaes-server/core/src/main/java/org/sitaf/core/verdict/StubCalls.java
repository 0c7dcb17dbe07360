package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;

/**
 * The component's calls of required interfaces in a case.
 *
 * @param recorded the recorded calls in their order
 * @param leftOut number of further calls that were not recorded
 */
public record StubCalls(List<Call> recorded, long leftOut) {
  /** No calls. */
  public static final StubCalls NONE = new StubCalls(List.of(), 0);

  public StubCalls {
    recorded = List.copyOf(recorded);
    if (leftOut < 0) {
      throw new IllegalArgumentException("calls_left_out must be at least 0, not " + leftOut);
    }
  }

  /**
   * One call.
   *
   * @param method {@code Interface.Method}
   * @param arguments input arguments in the order of the parameters
   */
  public record Call(String method, List<NamedValue> arguments) {
    public Call {
      Objects.requireNonNull(method);
      arguments = List.copyOf(arguments);
    }
  }
}
