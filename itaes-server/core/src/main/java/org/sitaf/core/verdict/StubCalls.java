package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;

/**
 * The component's calls of required interfaces in a case.
 *
 * @param recorded in their order
 * @param leftOut how many further calls were not recorded
 */
public record StubCalls(List<Call> recorded, long leftOut) {
  /** No call. */
  public static final StubCalls NONE = new StubCalls(List.of(), 0);

  public StubCalls {
    recorded = List.copyOf(recorded);
    if (leftOut < 0) {
      throw new IllegalArgumentException("calls_left_out is 0 or more, not " + leftOut);
    }
  }

  /**
   * One call.
   *
   * @param method {@code Interface.Method}
   * @param arguments that came in, in the order of the parameters
   */
  public record Call(String method, List<NamedValue> arguments) {
    public Call {
      Objects.requireNonNull(method);
      arguments = List.copyOf(arguments);
    }
  }
}
