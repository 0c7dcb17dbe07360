package org.sitaf.server.result;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.verdict.TestResult;
import org.springframework.stereotype.Component;

/**
 * Whole results, the latest used: graphs, filters and comparisons look at every case, and a result
 * never changes.
 */
@Component
class ResultCache {
  private static final int MAX_CASES = 300_000;

  private final Map<String, TestResult> results = new LinkedHashMap<>(16, 0.75f, true);
  private int cases;

  synchronized Optional<TestResult> get(String buildId) {
    return Optional.ofNullable(results.get(buildId));
  }

  synchronized void put(String buildId, TestResult result) {
    TestResult old = results.put(buildId, result);
    cases += result.cases().size() - (old == null ? 0 : old.cases().size());
    var oldest = results.values().iterator();
    while (cases > MAX_CASES && oldest.hasNext()) {
      cases -= oldest.next().cases().size();
      oldest.remove();
    }
  }
}
