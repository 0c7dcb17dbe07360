package org.sitaf.server.git.bisection;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection;
import org.sitaf.server.build.Builds;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitEvent;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.Fetches;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.remote.History;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.git.source.SourceRows;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Service;
import org.springframework.transaction.event.TransactionalEventListener;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Advances searches: decides by the results of the commit that was built last, and requests the
 * builds of the next one. Everything that it knows is in the database, so it continues what a
 * server that died has left.
 */
@Service
class Bisector implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(Bisector.class);
  private static final int CHECK_S = 5;

  /** If most commits cannot be tested, a search would build all of them. */
  static final int MAX_TESTS = 50;

  private final BisectionRows rows;
  private final Criterion criterion;
  private final SourceRows sourceRows;
  private final GitSources sources;
  private final CommitRows commits;
  private final Fetches fetches;
  private final Builds builds;
  private final TransactionTemplate transaction;
  private final DiskSpace disk;
  private ScheduledExecutorService thread = DaemonTimer.named("git-bisections");
  private volatile boolean running;

  Bisector(
      BisectionRows rows,
      Criterion criterion,
      SourceRows sourceRows,
      GitSources sources,
      CommitRows commits,
      Fetches fetches,
      Builds builds,
      TransactionTemplate transaction,
      DiskSpace disk) {
    this.rows = rows;
    this.criterion = criterion;
    this.sourceRows = sourceRows;
    this.sources = sources;
    this.commits = commits;
    this.fetches = fetches;
    this.builds = builds;
    this.transaction = transaction;
    this.disk = disk;
  }

  /** Looks at the searches soon. */
  void request() {
    if (running) {
      thread.execute(this::check);
    }
  }

  @TransactionalEventListener
  void on(CommitEvent.Ended ended) {
    request();
  }

  private void check() {
    if (!disk.canWrite()) {
      return;
    }
    try {
      for (GitBisection search : rows.running()) {
        advanceSafely(search);
      }
    } catch (RuntimeException e) {
      if (running) {
        log.error("The searches for first bad commits cannot be read; retrying", e);
      }
    }
  }

  private void advanceSafely(GitBisection search) {
    try {
      advance(search);
    } catch (IOException | RuntimeException e) {
      // The source may have been deleted in the meantime.
      if (running && sourceRows.find(search.sourceId()).isPresent()) {
        log.error(
            "Search {} of source {} cannot continue; retrying",
            search.number(),
            search.sourceId(),
            e);
      }
    }
  }

  private void advance(GitBisection found) throws IOException {
    GitSource source = sourceRows.find(found.sourceId()).orElse(null);
    if (source == null) {
      return;
    }
    String problem = problem(found, source);
    if (problem != null) {
      end(found, GitBisection.State.FAILED, problem);
      return;
    }
    Bisection search = found.search();
    int tests = found.tested().size();
    for (OptionalInt next = search.next(); next.isPresent(); next = search.next()) {
      if (tests == MAX_TESTS) {
        end(
            found,
            GitBisection.State.UNCERTAIN,
            "The search has ended after "
                + MAX_TESTS
                + " commits, of which most could not be tested. Look at the reasons, then continue"
                + " with ./sitaf bisect on your machine.");
        return;
      }
      GitBisection.Commit commit = found.commits().get(next.getAsInt());
      Criterion.Decision decision = decide(found, source, commit).orElse(null);
      if (decision == null) {
        return;
      }
      tests++;
      if (!rows.tested(found, commit.position(), tests, decision.outcome(), decision.reason())) {
        return;
      }
      search.record(commit.position(), decision.outcome());
    }
    end(
        found,
        search.candidates().size() == 1 ? GitBisection.State.FOUND : GitBisection.State.UNCERTAIN,
        null);
  }

  /** Why a search cannot continue, and what to do. */
  private @Nullable String problem(GitBisection search, GitSource source) {
    if (!search.isOf(source)) {
      return "The URL, the branch or the folder of the Git source was changed. Ask again when the"
          + " commits of the branch have results.";
    }
    for (String end : List.of(search.good(), search.bad())) {
      if (commits.find(source.id(), 0, end).filter(commit -> !commit.replaced()).isEmpty()) {
        return "A force-push has removed "
            + end
            + " from the branch "
            + source.branch()
            + ". Ask again at the new commit.";
      }
    }
    return null;
  }

  /** Decides by the results of a commit; empty if they have to be waited for. */
  private Optional<Criterion.Decision> decide(
      GitBisection search, GitSource source, GitBisection.Commit commit) throws IOException {
    // The branch may have built it in the meantime.
    Optional<GitCommit> ofBranch =
        commits
            .find(source.id(), 0, commit.sha())
            .filter(known -> known.state() != GitCommit.State.SKIPPED);
    GitCommit built =
        ofBranch.or(() -> commits.find(source.id(), search.requestNo(), commit.sha())).orElse(null);
    if (built == null) {
      return build(search, source, commit);
    }
    return switch (built.state()) {
      case WAITING -> {
        fetches.requestBuilds(source.id());
        yield Optional.empty();
      }
      case BUILDING, SKIPPED -> Optional.empty();
      case DONE -> Optional.of(criterion.decide(search, commits.cells(built.id())));
      case INVALID -> Optional.of(Criterion.Decision.skipped(String.valueOf(built.problem())));
    };
  }

  private Optional<Criterion.Decision> build(
      GitBisection search, GitSource source, GitBisection.Commit commit) throws IOException {
    try (History history = History.open(sources.copy(source.id()))) {
      if (!history.contains(commit.sha())) {
        end(
            search,
            GitBisection.State.FAILED,
            "The server's copy of the repository no longer has the commit "
                + commit.sha()
                + ". Fetch the branch, then ask again.");
        return Optional.empty();
      }
    }
    String base = commits.find(source.id(), 0, search.good()).map(GitCommit::id).orElse(null);
    transaction.executeWithoutResult(
        status -> {
          // Another server may have been faster, or somebody may have cancelled the search.
          if (rows.lockRunning(search)
              && commits.find(source.id(), search.requestNo(), commit.sha()).isEmpty()) {
            String unused =
                commits.insert(
                    source.id(),
                    search.requestNo(),
                    false,
                    new History.Commit(
                        commit.sha(), commit.subject(), commit.author(), commit.authored()),
                    commits.nextPosition(source.id(), search.requestNo()),
                    GitCommit.State.WAITING,
                    base);
          }
        });
    fetches.requestBuilds(source.id());
    return Optional.empty();
  }

  /**
   * Ends a search, and cancels its builds.
   *
   * @return false if it has ended before
   */
  boolean end(GitBisection search, GitBisection.State state, @Nullable String problem) {
    if (!rows.end(search, state, problem)) {
      return false;
    }
    commits.skipWaiting(search.sourceId(), search.requestNo());
    for (String build : rows.unfinishedBuilds(search)) {
      try {
        builds.cancel(build, "The search for the first bad commit has ended.");
      } catch (RequestException e) {
        log.debug("Build {} has ended in the meantime", build, e);
      }
    }
    return true;
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = DaemonTimer.named("git-bisections");
    }
    running = true;
    var unused = thread.scheduleWithFixedDelay(this::check, 1, CHECK_S, TimeUnit.SECONDS);
  }

  @Override
  public void stop() {
    running = false;
    thread.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
