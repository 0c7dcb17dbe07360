package org.sitaf.server.git.forge;

import java.util.Optional;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.SourceRows;
import org.springframework.stereotype.Service;

/** Reports commits, as the statuses and comments of a forge do. */
@Service
public class CommitReports {
  private final CommitRows commits;
  private final SourceRows sources;
  private final StoredActivities activities;
  private final StatusTexts texts;

  CommitReports(
      CommitRows commits, SourceRows sources, StoredActivities activities, StatusTexts texts) {
    this.commits = commits;
    this.sources = sources;
    this.activities = activities;
    this.texts = texts;
  }

  /** The first report of a commit; empty if the commit is built for another one only. */
  public Optional<CommitReport> pending(String commitId) {
    return commits
        .find(commitId)
        .filter(GitCommit::isReported)
        .map(
            commit ->
                report(
                    commit,
                    new StatusTexts.Summary(
                        CommitStatus.Result.PENDING, StatusTexts.PENDING_DESCRIPTION),
                    Optional.empty()));
  }

  /** The report of a commit that has ended. Compares all values with those of its base. */
  public CommitReport finished(String commitId) {
    GitCommit commit = commits.find(commitId).orElseThrow();
    return report(
        commit,
        texts.summary(commit),
        Optional.of(
            new CommitReport.Details(
                commits.cells(commitId).stream().map(CommitReports::model).toList(),
                texts.comment(source(commit), commit))));
  }

  private CommitReport report(
      GitCommit commit, StatusTexts.Summary summary, Optional<CommitReport.Details> details) {
    GitSource source = source(commit);
    return new CommitReport(
        source.activityId(),
        activities.name(source.activityId()),
        commit.sha(),
        commit.subject(),
        commit.author(),
        source.branch(),
        commit.requestNo() == 0 ? Optional.empty() : Optional.of(commit.requestNo()),
        summary.result().text(),
        summary.description(),
        texts.page(source, commit),
        details);
  }

  private GitSource source(GitCommit commit) {
    return sources.find(commit.sourceId()).orElseThrow();
  }

  private static CommitReport.Model model(GitCell cell) {
    return new CommitReport.Model(
        cell.model(),
        cell.buildId(),
        cell.state().name(),
        cell.takenFrom(),
        cell.total(),
        cell.pass(),
        cell.compared(),
        cell.differing());
  }
}
