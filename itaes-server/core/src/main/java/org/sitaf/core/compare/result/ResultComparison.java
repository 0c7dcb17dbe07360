package org.sitaf.core.compare.result;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseDifferences;
import org.sitaf.core.compare.CaseRun;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.LostCoverage;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.compare.SlowerCases;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.TestResult;

/**
 * Compares two results of a model by the values that they contain. Cases with the same values are
 * the same case, whatever their numbers are. Differences have the numbers of the new result. They
 * are not confirmed by further runs.
 */
public final class ResultComparison {
  /** Units in the last place that do not count. */
  public static final int ULP = 4;

  private final Side base;
  private final Side now;
  private final TestSuite suite;
  private final CaseComparison judged;
  private final CaseComparison unjudged;
  private final RecordsOfResults records;
  private final Map<Integer, CaseRun> ofBase = new HashMap<>();
  private final Map<Integer, CaseRun> ofNow = new HashMap<>();
  private final List<CaseRecord> called = new ArrayList<>();

  /**
   * One of the results.
   *
   * @param signals of a case by its number; null if there are none
   */
  public record Side(TestResult result, IntFunction<@Nullable Trace> signals) {}

  /**
   * What the comparison knows in addition to the results.
   *
   * @param activity of the new result
   * @param model of the new result
   * @param suite of the new result
   * @param sameModel whether both results were judged by the same document of the model
   * @param isUnchanged whether both versions have the same source with this path
   */
  public record Context(
      Activity activity,
      TestModel model,
      TestSuite suite,
      boolean sameModel,
      Predicate<String> isUnchanged) {}

  private ResultComparison(Context context, Side base, Side now) {
    this.base = base;
    this.now = now;
    this.records = new RecordsOfResults(context.model());
    this.suite = suite(context, now.result());
    this.judged =
        new CaseComparison(context.activity(), context.model(), suite, ULP, context.sameModel());
    this.unjudged = new CaseComparison(context.activity(), context.model(), suite, ULP, false);
  }

  /**
   * Compares two results with the same parameters.
   *
   * @throws IllegalArgumentException if their parameters differ
   */
  public static Comparison of(Context context, Side base, Side now) {
    if (!base.result().parameters().stream()
        .map(p -> p.name())
        .toList()
        .equals(now.result().parameters().stream().map(p -> p.name()).toList())) {
      throw new IllegalArgumentException("results with other parameters cannot be compared");
    }
    return new ResultComparison(context, base, now).compare(context);
  }

  /** The cases of the result, and whether they are valid. */
  private static TestSuite suite(Context context, TestResult result) {
    Map<Integer, Boolean> valid = new HashMap<>();
    context.suite().cases().forEach(c -> valid.put(c.no(), c.valid()));
    return new TestSuite(
        context.suite().name(),
        "",
        context.model().name(),
        context.suite().generation(),
        result.parameters(),
        result.cases().stream()
            .filter(c -> c.values().size() == result.parameters().size())
            .map(c -> new TestCase(c.no(), valid.getOrDefault(c.no(), true), c.values(), List.of()))
            .toList());
  }

  private Comparison compare(Context context) {
    Map<Integer, Integer> matching = matching(base.result(), now.result());
    List<ComparedCase> compared = new ArrayList<>();
    List<Difference> differences = new ArrayList<>();
    List<Difference> lastBits = new ArrayList<>();
    List<NotComparable> lacking = new ArrayList<>();
    Map<Integer, CaseResult> left = byNumber(base.result());
    Map<Integer, CaseResult> right = byNumber(now.result());
    int onlyNow = 0;
    for (TestCase testCase : suite.cases()) {
      Integer numberBefore = matching.get(testCase.no());
      if (numberBefore == null) {
        onlyNow++;
        continue;
      }
      CaseDifferences found =
          compare(
              testCase,
              Objects.requireNonNull(left.get(numberBefore)),
              Objects.requireNonNull(right.get(testCase.no())));
      if (found.isCompared()) {
        compared.add(new ComparedCase(suite.modelName(), testCase.no(), judged.inputs(testCase)));
      }
      differences.addAll(found.differences());
      lastBits.addAll(found.lastBits());
      lacking.addAll(found.notComparable());
    }
    List<NotComparable> notComparable = new ArrayList<>(oncePerOutput(lacking));
    int onlyBase = left.size() - matching.size();
    addCount(notComparable, onlyBase, "BASE");
    addCount(notComparable, onlyNow, "NEW");
    addSuspicions(notComparable, "BASE", base.result());
    addSuspicions(notComparable, "NEW", now.result());
    Optional<String> failure = commonFailure(called.stream());
    if (failure.isPresent()) {
      compared.clear();
      notComparable.add(
          new NotComparable(
              suite.modelName(), 0, "", "no case begins with either version: " + failure.get()));
    }
    differences.addAll(lostCoverage(context, compared));
    return new Comparison(compared, differences, lastBits, List.of(), slower(), notComparable);
  }

  /** The numbers of the same cases: those in the base result by those in the new one. */
  public static Map<Integer, Integer> matching(TestResult base, TestResult now) {
    Map<CaseIdentity, Deque<Integer>> numbers = new HashMap<>();
    base.cases()
        .forEach(
            c -> numbers.computeIfAbsent(CaseIdentity.of(c), k -> new ArrayDeque<>()).add(c.no()));
    Map<Integer, Integer> matching = new HashMap<>();
    for (CaseResult each : now.cases()) {
      Integer before = numbers.getOrDefault(CaseIdentity.of(each), new ArrayDeque<>()).poll();
      if (before != null) {
        matching.put(each.no(), before);
      }
    }
    return matching;
  }

  private static Map<Integer, CaseResult> byNumber(TestResult result) {
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    result.cases().forEach(c -> byNumber.put(c.no(), c));
    return byNumber;
  }

  private CaseDifferences compare(TestCase testCase, CaseResult before, CaseResult after) {
    RecordsOfResults.Pair both = records.of(before, after);
    called.add(both.base());
    called.add(both.now());
    CaseRun left = new CaseRun(both.base(), before, base.signals().apply(before.no()));
    CaseRun right = new CaseRun(both.now(), after, now.signals().apply(after.no()));
    ofBase.put(testCase.no(), left);
    ofNow.put(testCase.no(), right);
    TestCase withSteps = CaseChanges.withSteps(after, testCase.valid());
    boolean sameExpectations =
        before.expected().equals(after.expected())
            && expectations(before).equals(expectations(after));
    return (sameExpectations ? judged : unjudged).compare(withSteps, left, right);
  }

  private static List<List<NamedValue>> expectations(CaseResult result) {
    return result.steps().stream().map(StepResult::expected).toList();
  }

  private List<Difference> slower() {
    Set<Integer> timed =
        ofNow.keySet().stream()
            .filter(no -> isTimed(ofBase.get(no)) && isTimed(ofNow.get(no)))
            .collect(Collectors.toSet());
    TestSuite repeated =
        suite.withCases(suite.cases().stream().filter(c -> timed.contains(c.no())).toList());
    return new SlowerCases(judged, repeated)
        .find(
            no -> Objects.requireNonNull(ofBase.get(no)),
            no -> Objects.requireNonNull(ofNow.get(no)));
  }

  private static boolean isTimed(@Nullable CaseRun run) {
    return run != null && run.result().repeated() != null;
  }

  /** Lost lines of sources that did not change. */
  private List<Difference> lostCoverage(Context context, List<ComparedCase> compared) {
    var before = base.result().coverage();
    var after = now.result().coverage();
    if (before == null || after == null || compared.isEmpty()) {
      return List.of();
    }
    LostCoverage lost = new LostCoverage(suite.modelName());
    lost.add(before, after, (path, line) -> context.isUnchanged().test(path) ? line : 0);
    return lost.differences();
  }

  private void addCount(List<NotComparable> notComparable, int count, String version) {
    if (count > 0) {
      notComparable.add(
          new NotComparable(
              suite.modelName(),
              0,
              "",
              "%d %s only in %s".formatted(count, count == 1 ? "case is" : "cases are", version)));
    }
  }

  private void addSuspicions(List<NotComparable> notComparable, String version, TestResult of) {
    if (of.isSuspect()) {
      notComparable.add(
          new NotComparable(
              suite.modelName(),
              0,
              "",
              version + ": the result cannot be trusted: " + String.join("; ", of.suspicions())));
    }
  }

  /** An output that is not comparable for the same reason in several cases is listed once. */
  public static List<NotComparable> oncePerOutput(List<NotComparable> lacking) {
    Map<List<String>, List<NotComparable>> same =
        lacking.stream()
            .collect(
                Collectors.groupingBy(
                    n ->
                        n.output().isEmpty()
                            ? List.of(Integer.toString(n.no()))
                            : List.of(n.output(), n.reason()),
                    LinkedHashMap::new,
                    Collectors.toList()));
    return same.values().stream()
        .map(
            entries -> {
              NotComparable first = entries.get(0);
              return entries.size() == 1
                  ? first
                  : new NotComparable(first.model(), 0, first.output(), first.reason());
            })
        .toList();
  }

  /** The error outside of the call under test that ends every case with both versions. */
  public static Optional<String> commonFailure(Stream<CaseRecord> recordsOfBoth) {
    Set<String> messages = new HashSet<>();
    boolean onlyErrors =
        recordsOfBoth
            .peek(record -> messages.add(record.message()))
            .allMatch(record -> record.outcome() == CaseRecord.Outcome.ERROR);
    return onlyErrors ? messages.stream().findFirst() : Optional.empty();
  }
}
