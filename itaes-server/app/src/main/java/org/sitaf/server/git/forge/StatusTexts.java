package org.sitaf.server.git.forge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.comparison.Comparisons;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.commit.CommitOutcomes;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.source.GitSource;
import org.springframework.stereotype.Component;

/** What statuses and comments say about a commit. */
@Component
class StatusTexts {
  /** Of a comment; the rest is on the page of the commit. */
  static final int MAX_LINES = 60;

  static final String PENDING_DESCRIPTION = "The tests are running.";

  private static final int MAX_CONTEXT = 200;
  private static final int MAX_DESCRIPTION = 140;
  private static final int MAX_GROUP = 400;

  private final CommitRows commits;
  private final CommitOutcomes outcomes;
  private final Comparisons comparisons;
  private final StoredActivities activities;
  private final String publicUrl;

  StatusTexts(
      CommitRows commits,
      CommitOutcomes outcomes,
      Comparisons comparisons,
      StoredActivities activities,
      GitSettings settings) {
    this.commits = commits;
    this.outcomes = outcomes;
    this.comparisons = comparisons;
    this.activities = activities;
    this.publicUrl = settings.publicUrl().toString().replaceAll("/+$", "");
  }

  /** Result and description of a final status. */
  record Summary(CommitStatus.Result result, String description) {}

  String context(GitSource source) {
    String name = "sitaf/" + activities.name(source.activityId());
    return name.length() <= MAX_CONTEXT ? name : name.substring(0, MAX_CONTEXT);
  }

  /** The page of a commit. */
  String page(GitSource source, GitCommit commit) {
    return publicUrl
        + "/activities/"
        + source.activityId()
        + "?tab=commits&commit="
        + commit.sha()
        + (commit.requestNo() == 0 ? "" : "&request=" + commit.requestNo());
  }

  Summary summary(GitCommit commit) {
    if (commit.state() == GitCommit.State.INVALID) {
      return new Summary(
          CommitStatus.Result.ERROR, shortened(plain(String.valueOf(commit.problem()))));
    }
    List<GitCell> cells = commits.cells(commit.id());
    Optional<GitCell> failed =
        cells.stream().filter(c -> c.state() != BuildState.DONE || c.suspect()).findFirst();
    if (failed.isPresent()) {
      GitCell cell = failed.get();
      String why =
          cell.suspect()
              ? "the verdicts cannot be trusted"
              : cell.failure() == null ? "the build was cancelled" : cell.failure();
      return new Summary(CommitStatus.Result.ERROR, shortened(plain(cell.model() + ": " + why)));
    }
    int total = sum(cells, GitCell::total);
    int passed = sum(cells, GitCell::pass);
    int differing = sum(cells, GitCell::differing);
    String text =
        total == passed
            ? "%d cases passed".formatted(total)
            : "%d of %d cases did not pass".formatted(total - passed, total);
    String base = outcomes.base(commit).map(GitCommit::shortSha).orElse(null);
    if (base != null) {
      text +=
          differing == 0
              ? "; no differences to " + base
              : "; %d differ from %s".formatted(differing, base);
    }
    return new Summary(
        total == passed ? CommitStatus.Result.SUCCESS : CommitStatus.Result.FAILURE,
        shortened(text));
  }

  private interface Count {
    @Nullable Integer of(GitCell cell);
  }

  private static int sum(List<GitCell> cells, Count count) {
    int sum = 0;
    for (GitCell cell : cells) {
      Integer number = count.of(cell);
      sum += number == null ? 0 : number;
    }
    return sum;
  }

  /** A comment in Markdown with the groups of differences, at most {@link #MAX_LINES} lines. */
  String comment(GitSource source, GitCommit commit) {
    List<String> lines = new ArrayList<>();
    Optional<GitCommit> base = outcomes.base(commit);
    lines.add(
        "**SITAF "
            + code(activities.name(source.activityId()))
            + "**: "
            + plain(
                switch (commit.state()) {
                  case WAITING, BUILDING -> "the tests are running.";
                  case SKIPPED ->
                      commit.requestNo() == 0
                          ? "a later commit of the same push was tested."
                          : "not tested: the request was closed or has got a later commit.";
                  case DONE, INVALID -> summary(commit).description() + ".";
                }));
    lines.add("");
    if (commit.state() == GitCommit.State.DONE) {
      List<GitCell> before = base.map(b -> commits.cells(b.id())).orElse(List.of());
      for (GitCell cell : commits.cells(commit.id())) {
        before.stream()
            .filter(b -> b.model().equals(cell.model()))
            .findFirst()
            .ifPresentOrElse(
                earlier -> addModel(lines, earlier, cell),
                () -> lines.add("- " + code(cell.model()) + ": " + verdicts(cell)));
      }
    }
    String link = "[All results](" + page(source, commit) + ")";
    if (lines.size() > MAX_LINES - 2) {
      int left = lines.size() - (MAX_LINES - 3);
      lines.subList(MAX_LINES - 3, lines.size()).clear();
      lines.add("- … and " + left + " more lines");
    }
    lines.add("");
    lines.add(link);
    return String.join("\n", lines) + "\n";
  }

  private void addModel(List<String> lines, GitCell earlier, GitCell cell) {
    String text = "- " + code(cell.model()) + ": " + verdicts(cell);
    if (cell.takenFrom() != null) {
      lines.add(text + "; not affected, the result was taken over");
      return;
    }
    if (cell.state() != BuildState.DONE || earlier.state() != BuildState.DONE) {
      lines.add(text);
      return;
    }
    try {
      Comparisons.Differences found = comparisons.differences(earlier.buildId(), cell.buildId());
      lines.add(text + "; %d of %d cases differ".formatted(found.differingCases(), found.cases()));
      found.groups().forEach(group -> lines.add("  - " + code(group.text())));
    } catch (RequestException | InvalidInputException | ComputationTimeoutException e) {
      lines.add(text + "; cannot be compared: " + code(String.valueOf(e.getMessage())));
    }
  }

  private static String verdicts(GitCell cell) {
    return cell.total() == null
        ? "no result"
        : "%d of %d passed".formatted(cell.pass(), cell.total());
  }

  /** Text from users as code, so that it is no markup and mentions nobody. */
  private static String code(String text) {
    String plain = plain(text).replace('`', '\'');
    return "`" + (plain.length() <= MAX_GROUP ? plain : plain.substring(0, MAX_GROUP) + "…") + "`";
  }

  private static String plain(String text) {
    return text.replaceAll("[\\p{Cc}\\p{Cf}\\s]+", " ").strip();
  }

  private static String shortened(String text) {
    return text.length() <= MAX_DESCRIPTION ? text : text.substring(0, MAX_DESCRIPTION - 1) + "…";
  }
}
