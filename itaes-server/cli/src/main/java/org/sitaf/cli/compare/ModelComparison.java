package org.sitaf.cli.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.CaseDifferences;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Confirmation;
import org.sitaf.core.compare.Confirmation.Decision;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.LostCoverage;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.compare.SlowerCases;
import org.sitaf.core.compare.result.OtherTools;
import org.sitaf.core.compare.result.ResultComparison;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.TestResult;

/** Compares both versions in the cases of one model. */
final class ModelComparison {
  private final TestSuite suite;
  private final CaseComparison comparison;
  private final VersionRuns base;
  private final VersionRuns now;
  private final ProgressLine progress;
  private int variation;

  private final List<ComparedCase> compared = new ArrayList<>();
  private final List<Difference> differences = new ArrayList<>();
  private final List<Difference> lastBits = new ArrayList<>();
  private final List<Difference> unstable = new ArrayList<>();
  private final List<Difference> slower = new ArrayList<>();
  private final List<NotComparable> notComparable = new ArrayList<>();
  private List<String> otherTools = List.of();

  /**
   * Prepares the comparison.
   *
   * @param suite the cases of the model of the new version
   */
  ModelComparison(
      TestSuite suite,
      CaseComparison comparison,
      VersionRuns base,
      VersionRuns now,
      ProgressLine progress) {
    this.suite = suite;
    this.comparison = comparison;
    this.base = base;
    this.now = now;
    this.progress = progress;
  }

  /**
   * The comparison, and the result of the new version.
   *
   * @param result null if a version could not be run
   * @param otherTools packages and tools that the versions do not share
   */
  record Outcome(Comparison comparison, @Nullable TestResult result, List<String> otherTools) {}

  /** Runs all cases with both versions, and the differing cases again. */
  Outcome run() throws IOException, InterruptedException {
    step("running %d cases with BASE".formatted(suite.cases().size()));
    Run firstBase = base.timed(suite, ++variation);
    if (!isUsable("BASE", firstBase)) {
      return outcome(null);
    }
    step("running %d cases with NEW".formatted(suite.cases().size()));
    Run firstNow = now.timed(suite, ++variation);
    if (!isUsable("NEW", firstNow)) {
      return outcome(null);
    }
    List<Difference> found = new ArrayList<>();
    List<NotComparable> lacking = new ArrayList<>();
    for (TestCase testCase : suite.cases()) {
      CaseDifferences inCase =
          comparison.compare(testCase, firstBase.of(testCase.no()), firstNow.of(testCase.no()));
      if (inCase.isCompared()) {
        compared.add(
            new ComparedCase(suite.modelName(), testCase.no(), comparison.inputs(testCase)));
      }
      found.addAll(inCase.differences());
      lastBits.addAll(inCase.lastBits());
      lacking.addAll(inCase.notComparable());
    }
    notComparable.addAll(ResultComparison.oncePerOutput(lacking));
    Optional<String> failure =
        ResultComparison.commonFailure(
            Stream.concat(
                firstBase.records().values().stream(), firstNow.records().values().stream()));
    if (failure.isPresent()) {
      compared.clear();
      add("no case begins with either version: " + failure.get());
      return outcome(firstNow.result());
    }
    otherTools = OtherTools.of(firstBase.result(), firstNow.result());
    confirm(found, firstBase, firstNow);
    confirmSlower(firstBase, firstNow);
    coverage();
    return outcome(firstNow.result());
  }

  private void step(String text) {
    progress.step(suite.modelName() + ": " + text);
  }

  private boolean isUsable(String label, Run run) {
    TestResult result = run.result();
    if (result == null) {
      add(label + ": " + run.problem());
      return false;
    }
    if (result.isSuspect()) {
      add(label + ": the result cannot be trusted: " + String.join("; ", result.suspicions()));
    }
    return true;
  }

  private void add(String reason) {
    notComparable.add(new NotComparable(suite.modelName(), 0, "", reason));
  }

  private Outcome outcome(@Nullable TestResult result) {
    return new Outcome(
        new Comparison(compared, differences, lastBits, unstable, slower, notComparable),
        result,
        otherTools);
  }

  /** Finds unchanged lines of the component's sources that are no longer executed. */
  private void coverage() throws IOException, InterruptedException {
    if (compared.isEmpty() || !base.hasSources() || !now.hasSources()) {
      return;
    }
    step("measuring the coverage");
    LostCoverage lost = new LostCoverage(suite.modelName());
    UnchangedLines lines = new UnchangedLines(base.files(), now.files());
    for (int i = 0; i <= Confirmation.RUNS; i++) {
      Run ofBase = base.covered(suite, ++variation);
      Run ofNow = now.covered(suite, ++variation);
      TestResult before = ofBase.result();
      TestResult after = ofNow.result();
      VersionRuns.delete(ofBase);
      VersionRuns.delete(ofNow);
      if (before == null
          || after == null
          || before.coverage() == null
          || after.coverage() == null) {
        return;
      }
      lost.add(before.coverage(), after.coverage(), lines::inNew);
      if (lost.isEmpty()) {
        return;
      }
      if (i < Confirmation.RUNS) {
        step(
            "lines are no longer executed; run %d of %d to confirm it"
                .formatted(i + 1, Confirmation.RUNS));
      }
    }
    differences.addAll(lost.differences());
  }

  /**
   * Repeats the differing cases. If some are unstable, an agreement of the others may be a
   * coincidence, so they run again. A component that keeps a state between cases needs all cases.
   */
  private void confirm(List<Difference> found, Run firstBase, Run firstNow)
      throws IOException, InterruptedException {
    Confirmation first = confirmed(found, only(found), firstBase, firstNow);
    List<Difference> dependent = new ArrayList<>(first.all(Decision.DEPENDS_ON_OTHER_CASES));
    Set<Difference> counted = new HashSet<>(first.all(Decision.CONFIRMED));
    if (!counted.isEmpty() && counted.size() + dependent.size() < found.size()) {
      List<Difference> again = first.all(Decision.CONFIRMED);
      Confirmation second = confirmed(again, only(again), firstBase, firstNow);
      dependent.addAll(second.all(Decision.DEPENDS_ON_OTHER_CASES));
      counted.retainAll(second.all(Decision.CONFIRMED));
    }
    if (!dependent.isEmpty()) {
      counted.addAll(confirmed(dependent, suite, firstBase, firstNow).all(Decision.CONFIRMED));
    }
    found.forEach(d -> (counted.contains(d) ? differences : unstable).add(d));
  }

  private TestSuite only(List<Difference> found) {
    Set<Integer> numbers = found.stream().map(Difference::no).collect(Collectors.toSet());
    return suite.withCases(suite.cases().stream().filter(c -> numbers.contains(c.no())).toList());
  }

  private Confirmation confirmed(
      List<Difference> found, TestSuite repeated, Run firstBase, Run firstNow)
      throws IOException, InterruptedException {
    Confirmation confirmation = new Confirmation(found);
    Further ofBase = new Further(base, repeated, firstBase);
    Further ofNow = new Further(now, repeated, firstNow);
    for (int i = 1; i <= Confirmation.RUNS && confirmation.isOpen(); i++) {
      step(
          "%d differences in %d cases; run %d of %d to confirm them"
              .formatted(found.size(), repeated.cases().size(), i, Confirmation.RUNS));
      ofBase.run(confirmation);
      ofNow.run(confirmation);
    }
    return confirmation;
  }

  /** The further runs of some cases with one version. */
  private final class Further {
    private final VersionRuns version;
    private final TestSuite repeated;
    private final Run first;
    private @Nullable Run firstFurther;

    Further(VersionRuns version, TestSuite repeated, Run first) {
      this.version = version;
      this.repeated = repeated;
      this.first = first;
    }

    void run(Confirmation confirmation) throws IOException, InterruptedException {
      Run further = version.once(repeated, ++variation);
      if (further.result() == null) {
        throw new IOException("a run to confirm differences failed: " + further.problem());
      }
      Run other = firstFurther;
      for (TestCase testCase : repeated.cases()) {
        int no = testCase.no();
        confirmation.add(
            comparison.disagreements(testCase, first.of(no), further.of(no)),
            other == null
                ? List.of()
                : comparison.disagreements(testCase, other.of(no), further.of(no)));
      }
      if (other == null) {
        firstFurther = further;
      } else {
        VersionRuns.delete(further);
      }
    }
  }

  /** Measures slower cases again in the other order, so that a busy machine makes none slower. */
  private void confirmSlower(Run firstBase, Run firstNow) throws IOException, InterruptedException {
    List<Difference> found = new SlowerCases(comparison, suite).find(firstBase::of, firstNow::of);
    if (found.isEmpty()) {
      return;
    }
    step("measuring %d slower cases again".formatted(found.size()));
    TestSuite repeated = only(found);
    Run secondNow = now.timed(repeated, ++variation);
    Run secondBase = base.timed(repeated, ++variation);
    if (Objects.isNull(secondNow.result()) || Objects.isNull(secondBase.result())) {
      return;
    }
    Set<Integer> again =
        new SlowerCases(comparison, repeated)
            .find(secondBase::of, secondNow::of).stream()
                .map(Difference::no)
                .collect(Collectors.toSet());
    found.stream().filter(d -> again.contains(d.no())).forEach(slower::add);
  }
}
