package org.sitaf.server.audit;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** How often somebody was refused of late, so that not every time need be kept. */
final class Refusals {
  private static final Duration WINDOW = Duration.ofMinutes(1);
  private static final int MOST_ADDRESSES = 5_000;

  /** What all have in common who come when too many addresses are known. */
  private static final String ELSEWHERE = "many";

  /** An enrolment says nothing of the one who tried; a name that was tried does. */
  private static final Map<String, Integer> KEPT = Map.of("enrol", 1);

  private static final int KEPT_OF_OTHERS = 30;

  private final Map<Source, Count> counts = new HashMap<>();

  private record Source(String action, String address) {}

  private record Count(Instant since, int count) {
    boolean isOver(Instant now) {
      return !since.plus(WINDOW).isAfter(now);
    }
  }

  /** So many more than were kept. */
  record Summary(String action, String address, int count) {}

  /**
   * Counts a refusal.
   *
   * @param summaries gets what was counted in the minute before
   * @return whether this one is kept
   */
  synchronized boolean isKept(String action, String address, Instant now, List<Summary> summaries) {
    Source known = new Source(action, address);
    Source source =
        counts.containsKey(known) || counts.size() < MOST_ADDRESSES
            ? known
            : new Source(action, ELSEWHERE);
    Count before = counts.get(source);
    if (before != null && before.isOver(now)) {
      add(source, before, summaries);
      before = null;
    }
    Count count =
        before == null ? new Count(now, 1) : new Count(before.since(), before.count() + 1);
    counts.put(source, count);
    return count.count() <= kept(action);
  }

  /** What was counted in minutes that are over, and is forgotten thereby. */
  synchronized List<Summary> over(Instant now) {
    List<Summary> summaries = new ArrayList<>();
    Iterator<Map.Entry<Source, Count>> all = counts.entrySet().iterator();
    while (all.hasNext()) {
      Map.Entry<Source, Count> entry = all.next();
      if (entry.getValue().isOver(now)) {
        add(entry.getKey(), entry.getValue(), summaries);
        all.remove();
      }
    }
    return summaries;
  }

  private static void add(Source source, Count count, List<Summary> summaries) {
    int more = count.count() - kept(source.action());
    if (more > 0) {
      summaries.add(new Summary(source.action(), source.address(), more));
    }
  }

  private static int kept(String action) {
    return KEPT.getOrDefault(action, KEPT_OF_OTHERS);
  }
}
