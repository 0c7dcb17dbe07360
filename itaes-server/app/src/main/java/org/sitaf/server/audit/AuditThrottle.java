package org.sitaf.server.audit;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Decides which rejected requests are stored in the audit log, and counts the others. */
final class AuditThrottle {
  private static final Duration WINDOW = Duration.ofMinutes(1);
  private static final int MAX_ADDRESSES = 5_000;

  /** Common address of all further clients when there are {@link #MAX_ADDRESSES}. */
  private static final String OTHER_ADDRESSES = "many";

  /** Events stored per address and minute. Rejected enrolments differ in nothing of interest. */
  private static final Map<String, Integer> MAX_STORED = Map.of("enrol", 1);

  private static final int DEFAULT_STORED = 30;

  private final Map<Source, Count> counts = new HashMap<>();

  private record Source(String action, String address) {}

  private record Count(Instant since, int count) {
    boolean isExpired(Instant now) {
      return !since.plus(WINDOW).isAfter(now);
    }
  }

  /** The number of events that were not stored. */
  record Summary(String action, String address, int count) {}

  /**
   * Counts a rejected request.
   *
   * @param summaries receives the summary of the previous minute, if it has ended
   * @return whether to store this event
   */
  synchronized boolean shouldStore(
      String action, String address, Instant now, List<Summary> summaries) {
    Source known = new Source(action, address);
    Source source =
        counts.containsKey(known) || counts.size() < MAX_ADDRESSES
            ? known
            : new Source(action, OTHER_ADDRESSES);
    Count before = counts.get(source);
    if (before != null && before.isExpired(now)) {
      add(source, before, summaries);
      before = null;
    }
    Count count =
        before == null ? new Count(now, 1) : new Count(before.since(), before.count() + 1);
    counts.put(source, count);
    return count.count() <= maxStored(action);
  }

  /** Removes the counts of past minutes and returns their summaries. */
  synchronized List<Summary> removeExpired(Instant now) {
    List<Summary> summaries = new ArrayList<>();
    Iterator<Map.Entry<Source, Count>> all = counts.entrySet().iterator();
    while (all.hasNext()) {
      Map.Entry<Source, Count> entry = all.next();
      if (entry.getValue().isExpired(now)) {
        add(entry.getKey(), entry.getValue(), summaries);
        all.remove();
      }
    }
    return summaries;
  }

  private static void add(Source source, Count count, List<Summary> summaries) {
    int more = count.count() - maxStored(source.action());
    if (more > 0) {
      summaries.add(new Summary(source.action(), source.address(), more));
    }
  }

  private static int maxStored(String action) {
    return MAX_STORED.getOrDefault(action, DEFAULT_STORED);
  }
}
