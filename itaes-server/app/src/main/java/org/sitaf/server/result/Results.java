package org.sitaf.server.result;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.io.ByteArrayInputStream;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/** Accepted results, and late results that do not count. */
@Service
public class Results {
  private static final String DOCUMENT_NAME = "result descriptor";

  /** Maximum number of cases in the cache. */
  private static final int MAX_CASES = 300_000;

  /** Number of earlier results that are searched for the first failure. */
  private static final int EARLIER_RESULTS = 200;

  private static final Duration CACHED = Duration.ofMinutes(30);

  private final ResultRows rows;

  /**
   * Cache of parsed results, because statistics, filters and comparisons need all cases. Each use
   * checks in the database whether the result still exists, because another server may have deleted
   * it.
   */
  private final Cache<Key, TestResult> parsed =
      Caffeine.newBuilder()
          .maximumWeight(MAX_CASES)
          .weigher((Key key, TestResult result) -> result.cases().size())
          .expireAfterAccess(CACHED)
          .build();

  Results(ResultRows rows) {
    this.rows = rows;
  }

  /**
   * Reads a test result descriptor.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if the document is invalid
   */
  public static TestResult read(byte[] document) {
    return TestResultXml.read(new ByteArrayInputStream(document), DOCUMENT_NAME);
  }

  /** Stores the accepted result of a build, within the transaction that ends the build. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void accept(
      String buildId, TestResult result, byte[] document, String sha256, Instant received) {
    rows.insert(buildId, result, document, sha256, received);
    // Pages and comparisons that follow a build need all cases.
    parsed.put(new Key(buildId, sha256), result);
  }

  /** Stores the result of an attempt that was abandoned before. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void storeSuperseded(long fencingToken, byte[] document, Instant received) {
    rows.insertSuperseded(fencingToken, document, received);
  }

  Overview overview(String buildId) {
    return rows.overview(buildId).orElseThrow(() -> noResult(buildId));
  }

  /**
   * Returns the parameters of the cases of a result.
   *
   * @throws RequestException if there is no result
   */
  public List<CaseParameter> parameters(String buildId) {
    return overview(buildId).parameters();
  }

  /**
   * Returns the document of an accepted result as the agent sent it.
   *
   * @throws RequestException if there is no result
   */
  public byte[] document(String buildId) {
    return rows.document(buildId).orElseThrow(() -> noResult(buildId));
  }

  /**
   * Returns a result with all its cases.
   *
   * @throws RequestException if there is no result
   */
  public TestResult load(String buildId) {
    return parsed.get(new Key(buildId, sha256(buildId)), key -> read(document(key.buildId())));
  }

  /**
   * Returns the SHA-256 of the document of a result.
   *
   * @throws RequestException if there is no result
   */
  public String sha256(String buildId) {
    return rows.sha256(buildId).orElseThrow(() -> noResult(buildId));
  }

  private record Key(String buildId, String sha256) {}

  /** Returns the coverage of the component; empty if it was not measured. */
  public Optional<Coverage> coverage(String buildId) {
    return Optional.ofNullable(load(buildId).coverage());
  }

  /** Cases in which a parameter has a value; a verdict of null means all. */
  Page<CaseResult> casesWithValue(
      String buildId, @Nullable Verdict verdict, String parameter, String value, Pageable page) {
    TestResult result = load(buildId);
    int index = result.parameters().stream().map(CaseParameter::name).toList().indexOf(parameter);
    if (index < 0) {
      throw RequestException.malformed("The result has no parameter '" + parameter + "'.");
    }
    List<CaseResult> matching =
        result.cases().stream()
            .filter(c -> verdict == null || c.verdict() == verdict)
            .filter(c -> index < c.values().size() && matches(c.values().get(index), value))
            .toList();
    return new PageImpl<>(
        matching.stream().skip(page.getOffset()).limit(page.getPageSize()).toList(),
        page,
        matching.size());
  }

  /** Numbers are equal by value: 5 matches 5.0. */
  private static boolean matches(String literal, String given) {
    if (literal.equals(given)) {
      return true;
    }
    try {
      return Double.parseDouble(literal) == Double.parseDouble(given);
    } catch (NumberFormatException e) {
      return false;
    }
  }

  /** Results of an activity, newest first; a model of null means all. */
  Page<HistoryView.Row> history(String activityId, @Nullable String model, Pageable page) {
    return rows.history(activityId, model, page);
  }

  /** Describes what failed in a result, and since when. */
  FailuresView failures(String buildId) {
    TestResult now = load(buildId);
    FailuresView.Earlier self = rows.asEarlier(buildId).orElseThrow(() -> noResult(buildId));
    List<FailuresView.Earlier> earlier = rows.earlier(buildId, EARLIER_RESULTS);
    return FailuresView.of(
        now, self, earlier, earlier.isEmpty() ? null : load(earlier.get(0).buildId()));
  }

  String activityName(String buildId) {
    return rows.activityName(buildId).orElseThrow(() -> noResult(buildId));
  }

  @Transactional(readOnly = true)
  Page<CaseResult> cases(String buildId, @Nullable Verdict verdict, Pageable page) {
    overview(buildId);
    return rows.cases(buildId, verdict, page);
  }

  private static RequestException noResult(String buildId) {
    return RequestException.notFound("result of build", buildId);
  }
}
