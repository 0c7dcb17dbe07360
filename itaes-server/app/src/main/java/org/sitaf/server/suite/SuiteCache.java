package org.sitaf.server.suite;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.suite.TestSuite;
import org.springframework.stereotype.Component;

/**
 * Suites as read from their documents, the latest used: a person who scrolls through 100,000 cases
 * must not have them parsed for every page.
 */
@Component
class SuiteCache {
  private static final int MAX_CASES = 500_000;

  private final Map<String, Entry> entries = new LinkedHashMap<>(16, 0.75f, true);
  private int cases;

  private record Entry(long version, TestSuite suite) {}

  synchronized Optional<TestSuite> get(String id, long version) {
    Entry entry = entries.get(id);
    return entry == null || entry.version != version ? Optional.empty() : Optional.of(entry.suite);
  }

  synchronized void put(String id, long version, TestSuite suite) {
    Entry old = entries.put(id, new Entry(version, suite));
    cases += suite.cases().size() - (old == null ? 0 : old.suite.cases().size());
    Iterator<Entry> oldest = entries.values().iterator();
    while (cases > MAX_CASES && oldest.hasNext()) {
      cases -= oldest.next().suite.cases().size();
      oldest.remove();
    }
  }
}
