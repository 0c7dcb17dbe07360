package org.sitaf.server.comparison;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.compare.result.OtherTools;
import org.sitaf.core.compare.result.ResultComparison;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.build.signal.StoredSignals;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.result.Results;
import org.springframework.stereotype.Service;

/** Compares the results of builds, as {@code ./sitaf compare} does with those of its own runs. */
@Service
public class Comparisons {
  /** Maximum number of entries of all comparisons in the cache. */
  private static final int MAX_ENTRIES = 200_000;

  private static final Duration CACHED = Duration.ofMinutes(30);

  private final Results results;
  private final BuiltVersions versions;
  private final StoredSignals signals;
  private final Computations computations;

  /**
   * A page asks several times for parts of one comparison. Each use checks in the database that the
   * results still exist.
   */
  private final Cache<Key, ComparedBuilds> compared =
      Caffeine.newBuilder()
          .maximumWeight(MAX_ENTRIES)
          .weigher((Key key, ComparedBuilds of) -> of.weight())
          .expireAfterAccess(CACHED)
          .build();

  private record Key(String base, String baseSha256, String now, String nowSha256) {}

  Comparisons(
      Results results, BuiltVersions versions, StoredSignals signals, Computations computations) {
    this.results = results;
    this.versions = versions;
    this.signals = signals;
    this.computations = computations;
  }

  /**
   * Compares the result of a build with an earlier one.
   *
   * @throws RequestException if one has no result, or they are of different models
   */
  ComparedBuilds of(String base, String now) {
    Key key = new Key(base, results.sha256(base), now, results.sha256(now));
    ComparedBuilds known = compared.getIfPresent(key);
    if (known != null) {
      return known;
    }
    ComparedBuilds found =
        computations.generation(
            "The comparison of the results", () -> compare(key.base(), key.now()));
    compared.put(key, found);
    return found;
  }

  /**
   * What differs between two results.
   *
   * @param cases number of cases that both builds executed
   * @param differingCases number of those that differ
   * @param groups of the differences, the largest last
   */
  public record Differences(int cases, int differingCases, List<Group> groups) {
    public Differences {
      groups = List.copyOf(groups);
    }

    /** Differences that have something in common. */
    public record Group(String text, int size) {}
  }

  /**
   * Returns what differs between the result of a build and an earlier one.
   *
   * @throws RequestException if one has no result, or they cannot be compared
   */
  public Differences differences(String base, String now) {
    ComparedBuilds found = of(base, now);
    return new Differences(
        found.cases(),
        found.differingCases(),
        found.groups().stream()
            .map(group -> new Differences.Group(group.text(), group.differences().size()))
            .toList());
  }

  /**
   * The differences in the cases of a build and an earlier one, without those that concern no
   * single case.
   *
   * @throws RequestException if one has no result, or they cannot be compared
   */
  public List<Difference> ofCases(String base, String now) {
    return of(base, now).differences().stream().filter(found -> found.no() > 0).toList();
  }

  private ComparedBuilds compare(String base, String now) {
    TestResult before = results.load(base);
    TestResult after = results.load(now);
    requireSameParameters(before, after);
    BuiltVersion version = versions.read(now, after.name());
    Map<String, String> filesBefore = versions.files(base);
    SignalTraces ofBase = new SignalTraces(signals, base);
    SignalTraces ofNow = new SignalTraces(signals, now);
    Comparison comparison =
        ResultComparison.of(
            new ResultComparison.Context(
                version.activity(),
                version.model(),
                version.suite(),
                isSame(version.model().source(), filesBefore, version.files()),
                path -> isSame(path, filesBefore, version.files())),
            new ResultComparison.Side(before, ofBase::of),
            new ResultComparison.Side(after, ofNow::of));
    return ComparedBuilds.of(
        withThinned(comparison, ofBase, ofNow, after.name()),
        after.parameters(),
        before.provenance(),
        after.provenance(),
        ResultComparison.matching(before, after),
        OtherTools.of(before, after));
  }

  private static boolean isSame(String path, Map<String, String> before, Map<String, String> now) {
    String sha256 = now.get(path);
    return sha256 != null && sha256.equals(before.get(path));
  }

  private static Comparison withThinned(
      Comparison found, SignalTraces base, SignalTraces now, String model) {
    TreeSet<Integer> thinned = new TreeSet<>(base.thinned());
    thinned.addAll(now.thinned());
    if (thinned.isEmpty()) {
      return found;
    }
    List<NotComparable> notComparable = new ArrayList<>(found.notComparable());
    notComparable.add(
        new NotComparable(
            model,
            0,
            "t",
            "the signals of %d %s are stored with fewer samples than steps"
                .formatted(thinned.size(), thinned.size() == 1 ? "case" : "cases")));
    return new Comparison(
        found.cases(),
        found.differences(),
        found.lastBits(),
        found.unstable(),
        found.slower(),
        notComparable);
  }

  private static void requireSameParameters(TestResult before, TestResult now) {
    List<String> old = before.parameters().stream().map(CaseParameter::name).toList();
    List<String> names = now.parameters().stream().map(CaseParameter::name).toList();
    if (!old.equals(names)) {
      throw RequestException.conflict(
          "The results cannot be compared: their parameters differ ("
              + old
              + " and "
              + names
              + ").");
    }
  }
}
