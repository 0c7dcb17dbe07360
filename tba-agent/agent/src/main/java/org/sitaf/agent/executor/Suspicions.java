package org.sitaf.agent.executor;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reasons why the results of an execution cannot be trusted. Each reason is logged once; their
 * number is limited.
 */
final class Suspicions {
  private static final int MAX_REASONS = 20;
  private static final int MAX_LENGTH = 300;

  private final OutputSink sink;
  private final Map<String, Long> counts = new LinkedHashMap<>();
  private long further;

  Suspicions(OutputSink sink) {
    this.sink = sink;
  }

  void add(String text) {
    String reason = text.length() <= MAX_LENGTH ? text : text.substring(0, MAX_LENGTH) + " ...";
    if (counts.containsKey(reason)) {
      counts.merge(reason, 1L, Long::sum);
    } else if (counts.size() < MAX_REASONS) {
      counts.put(reason, 1L);
      sink.remark("the result is suspect: " + reason);
    } else {
      further++;
    }
  }

  /** The reasons in order of appearance, with their number of occurrences. */
  List<String> reasons() {
    List<String> reasons = new ArrayList<>();
    counts.forEach(
        (reason, count) -> reasons.add(count == 1 ? reason : reason + " (" + count + " times)"));
    if (further > 0) {
      reasons.add("and " + further + " further reasons");
    }
    return reasons;
  }
}
