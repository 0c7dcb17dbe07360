package org.sitaf.server.git.bisection;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;
import org.springframework.stereotype.Component;

/** Reads what the REST interface shows of searches: commits with their builds. */
@Component
class BisectionViews {
  /** Candidates that are shown; more of them help nobody. */
  private static final int MAX_CANDIDATES = 100;

  /** More than a search builds. */
  private static final int MAX_BUILT = 2 * Bisector.MAX_TESTS;

  private final CommitRows commits;

  BisectionViews(CommitRows commits) {
    this.commits = commits;
  }

  BisectionView of(GitBisection found) {
    Bisection search = found.search();
    List<Integer> candidates = search.candidates();
    boolean known =
        found.state() == GitBisection.State.FOUND || found.state() == GitBisection.State.UNCERTAIN;
    List<GitBisection.Commit> firstBad =
        known
            ? candidates.stream().limit(MAX_CANDIDATES).map(found.commits()::get).toList()
            : List.of();
    OptionalInt next =
        found.state() == GitBisection.State.RUNNING ? search.next() : OptionalInt.empty();
    List<GitBisection.Commit> tested = found.tested();
    Built built = built(found, tested, firstBad);
    return new BisectionView(
        found.number(),
        found.state(),
        found.bad(),
        found.good(),
        found.wanted().kind(),
        found.criterion(),
        found.commits().size(),
        candidates.size(),
        built.count(),
        next.isPresent() ? found.commits().get(next.getAsInt()).sha() : null,
        tested.stream().map(commit -> view(found, commit, built)).toList(),
        firstBad.stream().map(commit -> view(found, commit, built)).toList(),
        found.problem(),
        found.askedBy(),
        found.created(),
        found.ended());
  }

  /**
   * The results of commits.
   *
   * @param count number of commits that were built for the search
   */
  private record Built(Map<String, List<GitCell>> cells, int count) {
    @Nullable GitCell cell(String sha, String model) {
      return cells.getOrDefault(sha, List.of()).stream()
          .filter(cell -> cell.model().equals(model))
          .findFirst()
          .orElse(null);
    }
  }

  private Built built(
      GitBisection found, List<GitBisection.Commit> tested, List<GitBisection.Commit> firstBad) {
    Set<String> shas = new LinkedHashSet<>();
    tested.forEach(commit -> shas.add(commit.sha()));
    for (GitBisection.Commit commit : firstBad) {
      shas.add(commit.sha());
      shas.add(before(found, commit));
    }
    List<GitCommit> rows = new ArrayList<>();
    // What the branch has built itself comes last, and replaces the others.
    List<GitCommit> own = commits.list(found.sourceId(), found.requestNo(), MAX_BUILT, 0);
    rows.addAll(own);
    commits.list(found.sourceId(), 0, shas).stream()
        .filter(commit -> commit.state() == GitCommit.State.DONE)
        .forEach(rows::add);
    Map<String, List<GitCell>> byId =
        commits.cells(rows.stream().map(GitCommit::id).toList()).stream()
            .collect(Collectors.groupingBy(GitCell::commitId));
    Map<String, List<GitCell>> bySha = new HashMap<>();
    rows.forEach(commit -> bySha.put(commit.sha(), byId.getOrDefault(commit.id(), List.of())));
    int count =
        (int)
            own.stream()
                .filter(
                    commit ->
                        byId.getOrDefault(commit.id(), List.of()).stream()
                            .anyMatch(cell -> cell.takenFrom() == null))
                .count();
    return new Built(bySha, count);
  }

  private static String before(GitBisection found, GitBisection.Commit commit) {
    return commit.position() == 0 ? found.good() : found.commits().get(commit.position() - 1).sha();
  }

  private static BisectionView.TestedCommitView view(
      GitBisection found, GitBisection.Commit commit, Built built) {
    List<BisectionView.BuildOfCommitView> results = new ArrayList<>();
    for (GitBisection.Model model : found.models()) {
      GitCell cell = built.cell(commit.sha(), model.name());
      if (cell != null) {
        GitCell earlier =
            commit.position() == 0 || isGood(found, commit.position() - 1)
                ? built.cell(before(found, commit), model.name())
                : null;
        results.add(
            new BisectionView.BuildOfCommitView(
                model.name(),
                cell.buildId(),
                cell.state(),
                earlier == null ? model.goodBuild() : earlier.buildId()));
      }
    }
    return new BisectionView.TestedCommitView(
        commit.sha(),
        commit.subject(),
        commit.author(),
        commit.authored(),
        commit.sha().equals(found.bad()) ? Bisection.Outcome.BAD : commit.outcome(),
        commit.reason(),
        results);
  }

  private static boolean isGood(GitBisection found, int position) {
    return found.commits().get(position).outcome() == Bisection.Outcome.GOOD;
  }
}
