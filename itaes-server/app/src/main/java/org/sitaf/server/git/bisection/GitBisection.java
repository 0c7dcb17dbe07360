package org.sitaf.server.git.bisection;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection;
import org.sitaf.server.git.source.GitSource;

/**
 * A search for the first bad commit of a branch.
 *
 * @param number from 1, within the source
 * @param url of the source when somebody asked, like branch and folder
 * @param good the last commit before that has results
 * @param bad the commit that somebody asked about
 * @param criterion what a bad commit does, for people
 * @param problem why the search ended without a result, and what to do
 * @param models those that decide
 * @param commits after the good one up to the bad one, the oldest first
 */
record GitBisection(
    String sourceId,
    int number,
    String url,
    String branch,
    String folder,
    String good,
    String bad,
    Wanted wanted,
    String criterion,
    State state,
    @Nullable String problem,
    String askedBy,
    Instant created,
    @Nullable Instant ended,
    List<Model> models,
    List<Commit> commits) {
  GitBisection {
    models = List.copyOf(models);
    commits = List.copyOf(commits);
  }

  /** How far a search is. */
  enum State {
    RUNNING,
    /** The first bad commit is known. */
    FOUND,
    /** One of several commits is the first bad one; the others cannot be tested. */
    UNCERTAIN,
    /** Something ended it; the problem says what to do. */
    FAILED,
    CANCELLED
  }

  /** What makes a commit bad. */
  enum Kind {
    /** A case fails that does not fail at the good commit. */
    FAILURES,
    /** A case has other values than at the good commit. */
    VALUES
  }

  /**
   * What decides.
   *
   * @param caseNo number of a case of the bad commit; null for all
   * @param output name of an output, signal or called method; null for all
   */
  record Wanted(Kind kind, @Nullable Integer caseNo, @Nullable String output) {}

  /** A model, and its builds of the good and the bad commit. */
  record Model(String name, String goodBuild, String badBuild) {}

  /**
   * A commit of the history.
   *
   * @param position from 0
   * @param outcome null until it was tested
   * @param reason why it is bad or cannot be tested
   * @param testNo the order of the tests, from 1; null until it was tested
   */
  record Commit(
      int position,
      String sha,
      String subject,
      String author,
      Instant authored,
      Bisection.@Nullable Outcome outcome,
      @Nullable String reason,
      @Nullable Integer testNo) {}

  /** Whether the source still has the settings for which somebody asked. */
  boolean isOf(GitSource source) {
    return source.url().equals(url)
        && source.branch().equals(branch)
        && source.folder().equals(folder);
  }

  /** The commits that were tested, in the order of the tests. */
  List<Commit> tested() {
    return commits.stream()
        .filter(commit -> commit.testNo() != null)
        .sorted(Comparator.comparing(Commit::testNo))
        .toList();
  }

  /**
   * The search as far as its tests have come. The history follows first parents, so that a merge is
   * one commit of it.
   */
  Bisection search() {
    Bisection search =
        new Bisection(
            IntStream.range(0, commits.size())
                .mapToObj(i -> i == 0 ? List.<Integer>of() : List.of(i - 1))
                .toList());
    for (Commit commit : tested()) {
      if (commit.outcome() != null) {
        search.record(commit.position(), commit.outcome());
      }
    }
    return search;
  }

  /**
   * What the rows of the commits that are built for it have in place of the number of a request.
   */
  int requestNo() {
    return -number;
  }
}
