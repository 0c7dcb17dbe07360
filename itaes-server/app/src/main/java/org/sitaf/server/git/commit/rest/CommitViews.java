package org.sitaf.server.git.commit.rest;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.commit.CommitOutcomes;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;
import org.springframework.stereotype.Component;

/** Reads what the REST interface shows of commits: their results and those of their bases. */
@Component
public class CommitViews {
  private final CommitRows commits;
  private final CommitOutcomes outcomes;

  CommitViews(CommitRows commits, CommitOutcomes outcomes) {
    this.commits = commits;
    this.outcomes = outcomes;
  }

  /** The views of commits, in the same order. */
  public List<CommitView> of(List<GitCommit> found) {
    Map<String, GitCommit> bases = new HashMap<>();
    List<String> ids = new ArrayList<>();
    for (GitCommit commit : found) {
      ids.add(commit.id());
      outcomes
          .base(commit)
          .ifPresent(
              base -> {
                bases.put(commit.id(), base);
                ids.add(base.id());
              });
    }
    Map<String, List<GitCell>> cells = new HashMap<>();
    commits
        .cells(ids)
        .forEach(c -> cells.computeIfAbsent(c.commitId(), key -> new ArrayList<>()).add(c));
    return found.stream()
        .map(
            commit -> {
              GitCommit base = bases.get(commit.id());
              int notBuilt = base == null ? 0 : commits.notBuilt(base, commit);
              return view(commit, base, notBuilt, cells);
            })
        .toList();
  }

  private static CommitView view(
      GitCommit commit, @Nullable GitCommit base, int notBuilt, Map<String, List<GitCell>> cells) {
    List<GitCell> before = base == null ? List.of() : cells.getOrDefault(base.id(), List.of());
    return new CommitView(
        commit.sha(),
        commit.requestNo(),
        commit.mergeBase(),
        commit.subject(),
        commit.author(),
        commit.authored(),
        commit.received(),
        commit.ended(),
        commit.state(),
        commit.problem(),
        base == null ? null : base.sha(),
        notBuilt,
        commit.replaced(),
        cells.getOrDefault(commit.id(), List.of()).stream()
            .map(
                cell ->
                    CommitView.CellView.of(
                        cell,
                        before.stream()
                            .filter(earlier -> earlier.model().equals(cell.model()))
                            .map(GitCell::buildId)
                            .findFirst()
                            .orElse(null)))
            .toList());
  }
}
