package org.sitaf.server.git.bisection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.data.domain.PageRequest;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Begins, lists and cancels searches for the first bad commits of branches. */
@Service
class GitBisections {
  /** Commits among which the server searches. */
  private static final int MAX_COMMITS = 1000;

  private final BisectionRows rows;
  private final Bisector bisector;
  private final Criterion criterion;
  private final GitSources sources;
  private final CommitRows commits;
  private final TransactionTemplate transaction;
  private final DiskSpace disk;

  GitBisections(
      BisectionRows rows,
      Bisector bisector,
      Criterion criterion,
      GitSources sources,
      CommitRows commits,
      TransactionTemplate transaction,
      DiskSpace disk) {
    this.rows = rows;
    this.bisector = bisector;
    this.criterion = criterion;
    this.sources = sources;
    this.commits = commits;
    this.transaction = transaction;
    this.disk = disk;
  }

  /** The commits to search, and the models that have results at both ends. */
  private record Range(GitCommit good, List<GitCommit> commits, List<GitBisection.Model> models) {}

  /** What decides, and the numbers of the cases by model. */
  private record Found(GitBisection.Wanted wanted, Map<GitBisection.Model, Set<Integer>> cases) {}

  /**
   * Begins a search.
   *
   * @throws RequestException if there is nothing to search, or the source has a search that runs
   */
  GitBisection begin(String activityId, BisectionRequest request) {
    GitSource source = sources.require(activityId);
    disk.requireForNewWork();
    Integer caseNo = request.checkedCase();
    requireNoneRuns(source);
    GitCommit bad = bad(source, request.checkedCommit());
    Range range = range(source, bad, request.model());
    Found found = found(range, request, caseNo);
    List<GitBisection.Commit> history = new ArrayList<>();
    for (GitCommit commit : range.commits()) {
      history.add(
          new GitBisection.Commit(
              history.size(),
              commit.sha(),
              commit.subject(),
              commit.author(),
              commit.authored(),
              null,
              null,
              null));
    }
    Map<String, Set<Integer>> casesByModel = new LinkedHashMap<>();
    found.cases().forEach((model, cases) -> casesByModel.put(model.name(), cases));
    int number =
        Objects.requireNonNull(
            transaction.execute(
                status -> {
                  rows.lock(source.id());
                  requireNoneRuns(source);
                  return rows.insert(
                      source,
                      range.good().sha(),
                      bad.sha(),
                      found.wanted(),
                      Criterion.text(found.wanted().kind(), casesByModel),
                      Caller.currentName(),
                      List.copyOf(found.cases().keySet()),
                      history);
                }));
    bisector.request();
    return require(activityId, number);
  }

  private void requireNoneRuns(GitSource source) {
    rows.running(source.id())
        .ifPresent(
            number -> {
              throw RequestException.conflict(
                  "Search " + number + " of this branch runs; cancel it, or wait until it ends.");
            });
  }

  private GitCommit bad(GitSource source, String sha) {
    GitCommit bad =
        commits
            .find(source.id(), 0, sha)
            .orElseThrow(() -> RequestException.notFound("commit of the branch", sha));
    if (bad.replaced()) {
      throw RequestException.conflict(
          "A force-push has removed " + bad.shortSha() + " from the branch; name a later commit.");
    }
    if (bad.state() != GitCommit.State.DONE) {
      throw RequestException.conflict(
          "Commit "
              + bad.shortSha()
              + " has no results ("
              + bad.state()
              + "); name a commit whose builds have ended.");
    }
    return bad;
  }

  /** Searches the last commit before that has a result of a model with a result. */
  private Range range(GitSource source, GitCommit bad, @Nullable String wanted) {
    List<GitCell> usable =
        commits.cells(bad.id()).stream()
            .filter(Criterion::isUsable)
            .filter(cell -> wanted == null || cell.model().equals(wanted))
            .toList();
    if (usable.isEmpty()) {
      throw RequestException.conflict(
          "Commit "
              + bad.shortSha()
              + " has no result "
              + (wanted == null ? "" : "of the model '" + wanted + "' ")
              + "that can be trusted; name another commit.");
    }
    List<GitCommit> after = new ArrayList<>();
    for (GitCommit commit : commits.branchUpTo(source.id(), bad.position(), MAX_COMMITS + 1)) {
      List<GitBisection.Model> models =
          commit.id().equals(bad.id()) || commit.state() != GitCommit.State.DONE
              ? List.of()
              : common(commits.cells(commit.id()), usable);
      if (!models.isEmpty()) {
        Collections.reverse(after);
        return new Range(commit, requireBetween(after, commit), models);
      }
      after.add(commit);
    }
    throw RequestException.conflict(
        "None of the "
            + Math.min(after.size() - 1, MAX_COMMITS)
            + " commits before "
            + bad.shortSha()
            + " has a result of the same model; use ./sitaf bisect on your machine.");
  }

  private static List<GitCommit> requireBetween(List<GitCommit> commits, GitCommit good) {
    if (commits.size() < 2) {
      throw RequestException.conflict(
          "There is no commit between "
              + commits.get(0).shortSha()
              + " and "
              + good.shortSha()
              + ", which has results. What differs came with "
              + commits.get(0).shortSha()
              + ".");
    }
    return commits;
  }

  private static List<GitBisection.Model> common(List<GitCell> before, List<GitCell> now) {
    List<GitBisection.Model> models = new ArrayList<>();
    for (GitCell cell : now) {
      before.stream()
          .filter(Criterion::isUsable)
          .filter(earlier -> earlier.model().equals(cell.model()))
          .findFirst()
          .ifPresent(
              earlier ->
                  models.add(
                      new GitBisection.Model(cell.model(), earlier.buildId(), cell.buildId())));
    }
    return models;
  }

  /** New failures, or else other values. */
  private Found found(Range range, BisectionRequest request, @Nullable Integer caseNo) {
    List<GitBisection.Kind> kinds =
        request.wantsValues()
            ? List.of(GitBisection.Kind.VALUES)
            : List.of(GitBisection.Kind.FAILURES, GitBisection.Kind.VALUES);
    for (GitBisection.Kind kind : kinds) {
      GitBisection.Wanted wanted = new GitBisection.Wanted(kind, caseNo, request.output());
      Map<GitBisection.Model, Set<Integer>> cases = new LinkedHashMap<>();
      for (GitBisection.Model model : range.models()) {
        Set<Integer> numbers = cases(range, model, wanted);
        if (!numbers.isEmpty()) {
          cases.put(model, numbers);
        }
      }
      if (!cases.isEmpty()) {
        return new Found(wanted, cases);
      }
    }
    throw RequestException.conflict(
        "No case that passed at "
            + range.good().shortSha()
            + " fails, and none gives other values. Name another commit"
            + (request.isWhole() ? "." : ", or leave out model, case and output."));
  }

  private Set<Integer> cases(Range range, GitBisection.Model model, GitBisection.Wanted wanted) {
    try {
      return criterion.cases(model, wanted);
    } catch (RequestException e) {
      // With several models, the others can still be compared.
      if (e.reason() == RequestException.Reason.CONFLICT && range.models().size() > 1) {
        return Set.of();
      }
      throw e;
    }
  }

  /** A page of the searches of an activity, and the number of all. */
  record Page(List<GitBisection> searches, long total) {}

  Page list(String activityId, PageRequest page) {
    String source = sources.require(activityId).id();
    return new Page(rows.list(source, page.getPageSize(), page.getOffset()), rows.count(source));
  }

  GitBisection require(String activityId, int number) {
    return rows.find(sources.require(activityId).id(), number)
        .orElseThrow(
            () -> RequestException.notFound("search of this branch", Integer.toString(number)));
  }

  /**
   * Cancels a search and its builds.
   *
   * @throws RequestException if it has ended
   */
  GitBisection cancel(String activityId, int number) {
    GitBisection search = require(activityId, number);
    if (!bisector.end(search, GitBisection.State.CANCELLED, null)) {
      throw RequestException.conflict("Search " + number + " has ended.");
    }
    return require(activityId, number);
  }
}
