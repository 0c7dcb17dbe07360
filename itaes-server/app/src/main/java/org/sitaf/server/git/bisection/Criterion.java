package org.sitaf.server.git.bisection;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.compare.result.ResultComparison;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.comparison.Comparisons;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.result.Results;
import org.springframework.stereotype.Component;

/**
 * Decides by results whether a commit is bad. Each commit has the cases of its own models; those
 * with the same values are the same case.
 */
@Component
class Criterion {
  /** Cases that a text lists. */
  private static final int SHOWN = 10;

  private final Results results;
  private final Comparisons comparisons;

  Criterion(Results results, Comparisons comparisons) {
    this.results = results;
    this.comparisons = comparisons;
  }

  /**
   * A decision.
   *
   * @param reason why the commit is bad or cannot be tested; empty if it is good
   */
  record Decision(Outcome outcome, String reason) {
    static final Decision GOOD = new Decision(Outcome.GOOD, "");

    static Decision skipped(String reason) {
      return new Decision(Outcome.SKIPPED, reason);
    }

    private static Decision bad(String reason) {
      return new Decision(Outcome.BAD, reason);
    }
  }

  /** Something different in a case of the bad commit. */
  private record Sign(int no, DifferenceClass kind, String output) {}

  /** The numbers of the cases of the bad commit that show that it is bad. */
  Set<Integer> cases(GitBisection.Model model, GitBisection.Wanted wanted) {
    return switch (wanted.kind()) {
      case FAILURES -> failing(model, wanted);
      case VALUES ->
          signs(model, wanted).stream()
              .map(Sign::no)
              .collect(Collectors.toCollection(TreeSet::new));
    };
  }

  /** The cases, for people. */
  static String text(GitBisection.Kind kind, Map<String, Set<Integer>> casesByModel) {
    String cases =
        casesByModel.entrySet().stream()
            .map(
                e ->
                    e.getKey()
                        + (e.getValue().size() == 1 ? ", case " : ", cases ")
                        + e.getValue().stream()
                            .limit(SHOWN)
                            .map(String::valueOf)
                            .collect(Collectors.joining(", "))
                        + (e.getValue().size() > SHOWN ? ", ..." : ""))
            .collect(Collectors.joining("; "));
    return (kind == GitBisection.Kind.FAILURES ? "Fails: " : "Gives other values: ") + cases;
  }

  /** Whether a build has a result that can be trusted. */
  static boolean isUsable(GitCell cell) {
    return cell.state() == BuildState.DONE && !cell.suspect() && cell.total() != null;
  }

  /** Decides by the builds of a commit that have all ended. */
  Decision decide(GitBisection search, List<GitCell> cells) {
    Decision decision = Decision.GOOD;
    for (GitBisection.Model model : search.models()) {
      Decision found = decide(model, search.wanted(), cell(cells, model.name()));
      if (found.outcome() == Outcome.BAD) {
        return found;
      }
      if (found.outcome() == Outcome.SKIPPED) {
        decision = found;
      }
    }
    return decision;
  }

  private static @Nullable GitCell cell(List<GitCell> cells, String model) {
    return cells.stream().filter(cell -> cell.model().equals(model)).findFirst().orElse(null);
  }

  private Decision decide(
      GitBisection.Model model, GitBisection.Wanted wanted, @Nullable GitCell cell) {
    if (cell == null) {
      return Decision.skipped("The commit has no model " + model.name() + ".");
    }
    if (!isUsable(cell)) {
      return Decision.skipped(model.name() + ": " + whyUnusable(cell));
    }
    try {
      return switch (wanted.kind()) {
        case FAILURES -> byFailures(model, failing(model, wanted), cell.buildId());
        case VALUES -> byValues(model, signs(model, wanted), cell.buildId());
      };
    } catch (ComputationTimeoutException e) {
      return Decision.skipped(model.name() + ": " + e.getMessage());
    } catch (RequestException e) {
      if (e.reason() == RequestException.Reason.BUSY) {
        throw e;
      }
      return Decision.skipped(model.name() + ": " + e.getMessage());
    }
  }

  private static String whyUnusable(GitCell cell) {
    if (cell.suspect()) {
      return "the verdicts cannot be trusted";
    }
    if (cell.state() == BuildState.CANCELLED) {
      return "the build was cancelled";
    }
    String failure = cell.failure();
    return failure == null ? "the build has no result" : failure;
  }

  private Set<Integer> failing(GitBisection.Model model, GitBisection.Wanted wanted) {
    TestResult good = results.load(model.goodBuild());
    TestResult bad = results.load(model.badBuild());
    Map<Integer, Integer> inGood = ResultComparison.matching(good, bad);
    Map<Integer, CaseResult> before = byNumber(good);
    Set<Integer> failing = new TreeSet<>();
    for (CaseResult each : bad.cases()) {
      CaseResult earlier = before.get(inGood.getOrDefault(each.no(), 0));
      if (isWanted(wanted, each.no())
          && isFailure(each)
          && earlier != null
          && earlier.verdict() == Verdict.PASS) {
        failing.add(each.no());
      }
    }
    return failing;
  }

  private static boolean isWanted(GitBisection.Wanted wanted, int no) {
    return wanted.caseNo() == null || wanted.caseNo() == no;
  }

  private static boolean isFailure(CaseResult result) {
    return result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
  }

  private static Map<Integer, CaseResult> byNumber(TestResult result) {
    Map<Integer, CaseResult> byNumber = new LinkedHashMap<>();
    result.cases().forEach(each -> byNumber.put(each.no(), each));
    return byNumber;
  }

  private Decision byFailures(GitBisection.Model model, Set<Integer> failing, String build) {
    TestResult now = results.load(build);
    Map<Integer, Integer> numbers = ResultComparison.matching(now, results.load(model.badBuild()));
    Map<Integer, CaseResult> cases = byNumber(now);
    for (int no : failing) {
      CaseResult found = cases.get(numbers.getOrDefault(no, 0));
      if (found != null && isFailure(found)) {
        return Decision.bad("%s, case %d: %s".formatted(model.name(), found.no(), why(found)));
      }
    }
    return missing(model, failing, numbers, cases);
  }

  private static String why(CaseResult result) {
    return result.message().isEmpty() ? result.verdict().name() : result.message();
  }

  /** A commit is good only if it executed every case that decides. */
  private static Decision missing(
      GitBisection.Model model,
      Set<Integer> deciding,
      Map<Integer, Integer> numbers,
      Map<Integer, CaseResult> cases) {
    for (int no : deciding) {
      CaseResult found = cases.get(numbers.getOrDefault(no, 0));
      if (found == null || found.verdict() == Verdict.DONT) {
        return Decision.skipped(
            "%s, case %d %s"
                .formatted(
                    model.name(),
                    no,
                    found == null ? "does not exist at this commit" : "was not executed"));
      }
    }
    return Decision.GOOD;
  }

  private List<Sign> signs(GitBisection.Model model, GitBisection.Wanted wanted) {
    List<Sign> signs = new ArrayList<>();
    for (Difference found : comparisons.ofCases(model.goodBuild(), model.badBuild())) {
      if (isWanted(wanted, found.no())
          && (wanted.output() == null || wanted.output().equals(found.output()))) {
        signs.add(new Sign(found.no(), found.kind(), found.output()));
      }
    }
    return signs;
  }

  private Decision byValues(GitBisection.Model model, List<Sign> signs, String build) {
    TestResult bad = results.load(model.badBuild());
    TestResult now = results.load(build);
    Map<Integer, Integer> inBad = ResultComparison.matching(bad, now);
    Set<Sign> wanted = Set.copyOf(signs);
    for (Difference found : comparisons.ofCases(model.goodBuild(), build)) {
      int no = inBad.getOrDefault(found.no(), 0);
      if (wanted.contains(new Sign(no, found.kind(), found.output()))) {
        return Decision.bad(
            "%s, case %d: %s%s instead of %s"
                .formatted(
                    model.name(),
                    found.no(),
                    found.output().isEmpty() ? "" : found.output() + " is ",
                    found.now(),
                    found.base()));
      }
    }
    return missing(
        model,
        signs.stream().map(Sign::no).collect(Collectors.toCollection(TreeSet::new)),
        ResultComparison.matching(now, bad),
        byNumber(now));
  }
}
