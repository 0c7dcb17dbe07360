package org.sitaf.runtime.stub;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.runtime.suite.CaseResult;

/** Records the calls of the component to its required interfaces in a case. Thread-safe. */
final class StubCalls {
  /** Maximum number of recorded calls per case; further calls are only counted. */
  static final int MAX_RECORDED = 1000;

  private final List<Call> recorded = new ArrayList<>();
  private long leftOut;

  private record Call(String method, List<String> parameters, List<String> arguments) {}

  synchronized void clear() {
    recorded.clear();
    leftOut = 0;
  }

  /** Whether the next call is recorded, so that its arguments are needed. */
  synchronized boolean hasRoom() {
    return recorded.size() < MAX_RECORDED;
  }

  synchronized void add(String method, List<String> parameters, List<String> arguments) {
    if (recorded.size() < MAX_RECORDED) {
      recorded.add(new Call(method, parameters, arguments));
    } else {
      leftOut++;
    }
  }

  synchronized void writeTo(CaseResult result) {
    for (Call call : recorded) {
      result.addCall(call.method(), call.parameters(), call.arguments());
    }
    result.addCallsLeftOut(leftOut);
  }

  /** Moves the calls so far to a result. */
  synchronized void moveTo(CaseResult result) {
    writeTo(result);
    clear();
  }
}
