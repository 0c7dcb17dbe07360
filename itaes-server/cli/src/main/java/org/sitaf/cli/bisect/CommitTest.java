package org.sitaf.cli.bisect;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sitaf.cli.compare.BaseModel;
import org.sitaf.cli.compare.Run;
import org.sitaf.cli.compare.Version;
import org.sitaf.cli.compare.VersionRuns;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseDifferences;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Decides for each version whether it is bad. The cases are those of the bad version's models.
 * Either some of them fail, or they give other values than the good version.
 */
final class CommitTest {
  private static final int ULP = 4;

  private final LocalBuilds builds;
  private final Version bad;
  private final Map<TestModel, TestSuite> suites;
  private final Map<TestModel, Run> good = new LinkedHashMap<>();
  private final Map<TestModel, Set<Integer>> failing = new LinkedHashMap<>();
  private final Map<TestModel, Set<Sign>> different = new LinkedHashMap<>();
  private int count;

  CommitTest(LocalBuilds builds, Version bad, Map<TestModel, TestSuite> suites) {
    this.builds = builds;
    this.bad = bad;
    this.suites = suites;
  }

  /** What is different in a case of the bad version. */
  private record Sign(int no, DifferenceClass kind, String output) {
    static Sign of(Difference difference) {
      return new Sign(difference.no(), difference.kind(), difference.output());
    }
  }

  /**
   * The outcome of a test.
   *
   * @param reason the first case that is bad, or why the version cannot be tested
   */
  record Tested(Outcome outcome, String reason) {}

  /** The number of versions that were built so far. */
  int builds() {
    return count;
  }

  /** The cases that decide, for a message. */
  String criterion() {
    return different.isEmpty()
        ? "fails: " + numbers(failing)
        : "gives other values than GOOD: "
            + numbers(
                different.entrySet().stream()
                    .collect(
                        Collectors.toMap(
                            Map.Entry::getKey,
                            e ->
                                e.getValue().stream()
                                    .map(Sign::no)
                                    .collect(Collectors.toCollection(TreeSet::new)),
                            (a, b) -> a,
                            LinkedHashMap::new)));
  }

  private static String numbers(Map<TestModel, Set<Integer>> cases) {
    return cases.entrySet().stream()
        .map(
            e ->
                e.getKey().name()
                    + (e.getValue().size() == 1 ? ", case " : ", cases ")
                    + e.getValue().stream()
                        .limit(10)
                        .map(String::valueOf)
                        .collect(Collectors.joining(", "))
                    + (e.getValue().size() > 10 ? ", ..." : ""))
        .collect(Collectors.joining("; "));
  }

  /**
   * Runs the bad version.
   *
   * @return whether cases fail, which decides then
   * @throws InvalidInputException if it cannot be run
   */
  boolean learnFailures() throws IOException, InterruptedException {
    count++;
    for (Map.Entry<TestModel, TestSuite> entry : suites.entrySet()) {
      Run run = run(bad, entry.getKey(), entry.getValue());
      if (run.result() == null) {
        throw InvalidInputException.of("BAD", "cannot be run: " + run.problem());
      }
      Set<Integer> failed = new TreeSet<>();
      run.results().values().stream()
          .filter(CommitTest::isFailure)
          .forEach(result -> failed.add(result.no()));
      if (!failed.isEmpty()) {
        failing.put(entry.getKey(), failed);
      }
      good.put(entry.getKey(), run);
    }
    return !failing.isEmpty();
  }

  /**
   * Runs the good version and compares: differing values decide then.
   *
   * @throws InvalidInputException if it cannot be run, or nothing differs
   */
  void learnDifferences(Version goodVersion) throws IOException, InterruptedException {
    count++;
    failing.clear();
    for (Map.Entry<TestModel, TestSuite> entry : suites.entrySet()) {
      TestModel model = entry.getKey();
      BaseModel inGood = BaseModel.of(goodVersion.activity(), bad.activity(), model);
      TestModel adapted = inGood.model();
      if (adapted == null) {
        throw InvalidInputException.of("GOOD", firstReason(inGood));
      }
      Run ofGood = run(goodVersion, adapted, entry.getValue());
      if (ofGood.result() == null) {
        throw InvalidInputException.of("GOOD", "cannot be run: " + ofGood.problem());
      }
      Run ofBad = good.put(model, ofGood);
      Set<Sign> signs =
          differences(model, ofGood, Objects.requireNonNull(ofBad)).stream()
              .map(Sign::of)
              .collect(Collectors.toSet());
      if (!signs.isEmpty()) {
        different.put(model, signs);
      }
    }
    if (different.isEmpty()) {
      throw InvalidInputException.of(
          "BAD", "no case fails, and GOOD gives the same values; choose other cases or revisions");
    }
  }

  /** Tests a version. */
  Tested test(Version version) throws IOException, InterruptedException {
    count++;
    boolean compares = !different.isEmpty();
    for (TestModel model : compares ? different.keySet() : failing.keySet()) {
      BaseModel inVersion = BaseModel.of(version.activity(), bad.activity(), model);
      TestModel adapted = inVersion.model();
      if (adapted == null || !compares && !inVersion.judged()) {
        return new Tested(Outcome.SKIPPED, firstReason(inVersion));
      }
      Run run = run(version, adapted, suite(model));
      if (run.result() == null) {
        return new Tested(Outcome.SKIPPED, run.problem());
      }
      Optional<Tested> found = compares ? compared(model, run) : judged(model, run);
      if (found.isPresent()) {
        return found.get();
      }
    }
    return new Tested(Outcome.GOOD, "");
  }

  private TestSuite suite(TestModel model) {
    return Objects.requireNonNull(suites.get(model));
  }

  private Optional<Tested> judged(TestModel model, Run run) {
    for (int no : failing.getOrDefault(model, Set.of())) {
      CaseResult result = run.results().get(no);
      if (result == null || result.verdict() == Verdict.DONT) {
        return Optional.of(new Tested(Outcome.SKIPPED, "case " + no + " was not executed"));
      }
      if (isFailure(result)) {
        return Optional.of(new Tested(Outcome.BAD, "case " + no + ": " + result.message()));
      }
    }
    return Optional.empty();
  }

  private Optional<Tested> compared(TestModel model, Run run) {
    Set<Sign> signs = different.getOrDefault(model, Set.of());
    return differences(model, Objects.requireNonNull(good.get(model)), run).stream()
        .filter(difference -> signs.contains(Sign.of(difference)))
        .findFirst()
        .map(
            d ->
                new Tested(
                    Outcome.BAD,
                    "case %d: %s%s instead of %s"
                        .formatted(
                            d.no(),
                            d.output().isEmpty() ? "" : d.output() + " is ",
                            d.now(),
                            d.base())));
  }

  private List<Difference> differences(TestModel model, Run before, Run after) {
    CaseComparison comparison = new CaseComparison(bad.activity(), model, suite(model), ULP, false);
    List<Difference> all = new ArrayList<>();
    for (TestCase testCase : suite(model).cases()) {
      CaseDifferences found =
          comparison.compare(testCase, before.of(testCase.no()), after.of(testCase.no()));
      all.addAll(found.differences());
    }
    return all;
  }

  private Run run(Version version, TestModel model, TestSuite suite)
      throws IOException, InterruptedException {
    return new VersionRuns(builds, version, model).once(suite, 0);
  }

  private static boolean isFailure(CaseResult result) {
    return result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
  }

  private static String firstReason(BaseModel model) {
    return model.notComparable().isEmpty()
        ? "the model does not apply"
        : model.notComparable().get(0).reason();
  }
}
