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
import org.sitaf.server.refusal.Refusal;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageImpl;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/** Accepted results, and those that came too late. */
@Service
public class Results {
  private static final String DOCUMENT_NAME = "result descriptor";

  /** Of all results in memory together. */
  private static final int MAX_CASES = 300_000;

  private static final Duration KEPT = Duration.ofMinutes(30);

  private final ResultRows rows;

  /**
   * The results used last: graphs, filters and comparisons look at every case. The database is
   * asked for each use whether the result still exists, since another server may have deleted it.
   */
  private final Cache<Key, TestResult> parsed =
      Caffeine.newBuilder()
          .maximumWeight(MAX_CASES)
          .weigher((Key key, TestResult result) -> result.cases().size())
          .expireAfterAccess(KEPT)
          .build();

  Results(ResultRows rows) {
    this.rows = rows;
  }

  /**
   * Reads a test result descriptor.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException when it is none
   */
  public static TestResult read(byte[] document) {
    return TestResultXml.read(new ByteArrayInputStream(document), DOCUMENT_NAME);
  }

  /** Stores the result of a build, within the transaction that ends the build. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void accept(
      String buildId, TestResult result, byte[] document, String sha256, Instant received) {
    rows.insert(buildId, result, document, sha256, received);
  }

  /** Keeps a result that came after its attempt was given up; it counts nowhere. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void keepSuperseded(long fencingToken, byte[] document, Instant received) {
    rows.insertSuperseded(fencingToken, document, received);
  }

  Overview overview(String buildId) {
    return rows.overview(buildId).orElseThrow(() -> noResult(buildId));
  }

  /**
   * The document of an accepted result, as it came.
   *
   * @throws Refusal when there is none
   */
  public byte[] document(String buildId) {
    return rows.document(buildId).orElseThrow(() -> noResult(buildId));
  }

  /**
   * A result with all of its cases.
   *
   * @throws Refusal when there is none, be it that it was deleted
   */
  TestResult whole(String buildId) {
    String sha256 = rows.sha256(buildId).orElseThrow(() -> noResult(buildId));
    return parsed.get(new Key(buildId, sha256), key -> read(document(key.buildId())));
  }

  private record Key(String buildId, String sha256) {}

  /** What was reached of the component; empty where that was not measured. */
  public Optional<Coverage> coverage(String buildId) {
    return Optional.ofNullable(whole(buildId).coverage());
  }

  /** Cases of a verdict, or all, in which a parameter has a value. */
  Page<CaseResult> casesWith(
      String buildId, @Nullable Verdict verdict, String parameter, String value, Pageable page) {
    TestResult result = whole(buildId);
    int index = result.parameters().stream().map(CaseParameter::name).toList().indexOf(parameter);
    if (index < 0) {
      throw Refusal.malformed("The result has no parameter '" + parameter + "'.");
    }
    List<CaseResult> fitting =
        result.cases().stream()
            .filter(c -> verdict == null || c.verdict() == verdict)
            .filter(c -> index < c.values().size() && isSame(c.values().get(index), value))
            .toList();
    return new PageImpl<>(
        fitting.stream().skip(page.getOffset()).limit(page.getPageSize()).toList(),
        page,
        fitting.size());
  }

  /** People write 5 for 5.0. */
  private static boolean isSame(String literal, String given) {
    if (literal.equals(given)) {
      return true;
    }
    try {
      return Double.parseDouble(literal) == Double.parseDouble(given);
    } catch (NumberFormatException e) {
      return false;
    }
  }

  /** Results of an activity, of one model or all, the newest first. */
  Page<HistoryView.Row> history(String activityId, @Nullable String model, Pageable page) {
    return rows.history(activityId, model, page);
  }

  String activityName(String buildId) {
    return rows.activityName(buildId).orElseThrow(() -> noResult(buildId));
  }

  @Transactional(readOnly = true)
  Page<CaseResult> cases(String buildId, @Nullable Verdict verdict, Pageable page) {
    overview(buildId);
    return rows.cases(buildId, verdict, page);
  }

  private static Refusal noResult(String buildId) {
    return Refusal.notFound("result of build", buildId);
  }
}
