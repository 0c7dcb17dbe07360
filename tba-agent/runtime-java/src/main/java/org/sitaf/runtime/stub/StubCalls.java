package org.sitaf.runtime.stub;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.runtime.suite.CaseResult;

/** Records what the component asks of its required interfaces in a case; safe for its threads. */
final class StubCalls {
  /** Most calls that are kept of a case; the rest is counted. */
  static final int MAX_RECORDED = 1000;

  private final List<Call> recorded = new ArrayList<>();
  private long leftOut;

  private record Call(String method, List<String> parameters, List<String> arguments) {}

  synchronized void forget() {
    recorded.clear();
    leftOut = 0;
  }

  /** Whether a further call is recorded; only then its arguments are written. */
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
}
