package org.sitaf.cli.bisect;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.cli.compare.BaseModel;
import org.sitaf.cli.compare.Run;
import org.sitaf.cli.compare.Version;
import org.sitaf.cli.compare.VersionRuns;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** Executes versions of a component with the cases of the bad version. */
final class VersionTests {
  private final LocalBuilds builds;
  private final Version bad;
  private final Map<TestModel, TestSuite> suites;
  private int count;

  VersionTests(LocalBuilds builds, Version bad, Map<TestModel, TestSuite> suites) {
    this.builds = builds;
    this.bad = bad;
    this.suites = suites;
  }

  /**
   * The execution of a version.
   *
   * @param runs by the models of the bad version; empty if the version cannot be tested
   * @param unjudged models whose expected values do not apply to the version
   * @param problem why it cannot be tested; empty otherwise
   */
  record Tested(Map<TestModel, Run> runs, Set<String> unjudged, String problem) {
    static Tested impossible(String problem) {
      return new Tested(Map.of(), Set.of(), problem);
    }

    /** The cases that fail, by model. */
    Map<TestModel, Set<Integer>> failing() {
      Map<TestModel, Set<Integer>> failing = new LinkedHashMap<>();
      runs.forEach(
          (model, run) -> {
            Set<Integer> numbers = new TreeSet<>();
            run.results().values().stream()
                .filter(Tested::isFailure)
                .forEach(result -> numbers.add(result.no()));
            if (!numbers.isEmpty()) {
              failing.put(model, numbers);
            }
          });
      return failing;
    }

    static boolean isFailure(CaseResult result) {
      return result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
    }
  }

  /** The number of versions that were executed so far. */
  int count() {
    return count;
  }

  /** Executes all cases with a version. */
  Tested test(Version version) throws IOException, InterruptedException {
    count++;
    Map<TestModel, Run> runs = new LinkedHashMap<>();
    Set<String> unjudged = new TreeSet<>();
    for (Map.Entry<TestModel, TestSuite> entry : suites.entrySet()) {
      TestModel model = entry.getKey();
      BaseModel inVersion = BaseModel.of(version.activity(), bad.activity(), model);
      TestModel adapted = inVersion.model();
      if (adapted == null) {
        return Tested.impossible(inVersion.notComparable().get(0).reason());
      }
      if (!inVersion.judged()) {
        unjudged.add(model.name());
      }
      Run run = new VersionRuns(builds, version, adapted).once(entry.getValue(), 0);
      if (run.result() == null) {
        return Tested.impossible(run.problem());
      }
      List<String> suspicions = run.result().suspicions();
      if (run.result().isSuspect()) {
        return Tested.impossible("the result cannot be trusted: " + String.join("; ", suspicions));
      }
      runs.put(model, run);
    }
    return new Tested(runs, unjudged, "");
  }

  /** Deletes the signals of an execution that is not compared any more. */
  static void deleteSignals(Tested tested) throws IOException {
    for (Run run : tested.runs().values()) {
      VersionRuns.delete(run);
    }
  }
}
