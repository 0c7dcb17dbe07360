package org.sitaf.server.history;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.io.ByteArrayInputStream;
import java.time.Duration;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.file.StoredFiles;
import org.springframework.stereotype.Component;

/** Knows which cases of builds have invalid inputs, from the suites that were built. */
@Component
class ValidCases {
  private static final int MAX_NUMBERS = 500_000;
  private static final Duration CACHED = Duration.ofMinutes(30);

  private final CaseHistoryRows rows;
  private final StoredFiles contents;

  /** Numbers of cases by SHA-256 of their suite. Most commits have the suite of the one before. */
  private final Cache<String, Set<Integer>> invalid =
      Caffeine.newBuilder()
          .maximumWeight(MAX_NUMBERS)
          .weigher((String sha256, Set<Integer> numbers) -> 1 + numbers.size())
          .expireAfterAccess(CACHED)
          .build();

  ValidCases(CaseHistoryRows rows, StoredFiles contents) {
    this.rows = rows;
    this.contents = contents;
  }

  /** The numbers of cases with invalid inputs by build. */
  Map<String, Set<Integer>> invalid(Collection<String> buildIds) {
    Map<String, Set<Integer>> numbers = new HashMap<>();
    rows.suites(buildIds)
        .forEach(
            (build, suites) -> {
              Set<Integer> all = new TreeSet<>();
              suites.forEach(sha256 -> all.addAll(invalid.get(sha256, this::read)));
              numbers.put(build, all);
            });
    return numbers;
  }

  private Set<Integer> read(String sha256) {
    return TestSuiteXml.read(new ByteArrayInputStream(contents.content(sha256)), "suite.xml")
        .cases()
        .stream()
        .filter(each -> !each.valid())
        .map(TestCase::no)
        .collect(Collectors.toUnmodifiableSet());
  }
}
