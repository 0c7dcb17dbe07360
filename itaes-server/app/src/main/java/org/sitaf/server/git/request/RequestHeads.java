package org.sitaf.server.git.request;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.jgit.transport.RefSpec;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.Fetches;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.remote.History;
import org.sitaf.server.git.remote.RemoteException;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.stereotype.Component;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Fetches the heads of requests, and records them as commits that are compared with their merge
 * bases. What goes wrong is stored with the request, so that no request stops the branch.
 */
@Component
class RequestHeads implements Fetches.Heads {
  private static final Logger log = LoggerFactory.getLogger(RequestHeads.class);

  /** Failed fetches of a head; then a message of the forge or a person has to ask again. */
  private static final int MAX_FAILURES = 5;

  private final RequestRows rows;
  private final GitSources sources;
  private final CommitRows commits;
  private final TransactionTemplate transaction;

  RequestHeads(
      RequestRows rows, GitSources sources, CommitRows commits, TransactionTemplate transaction) {
    this.rows = rows;
    this.sources = sources;
    this.commits = commits;
    this.transaction = transaction;
  }

  /** A request, and the head that was fetched. */
  private record Fetched(GitRequest request, String head) {}

  @Override
  public Fetches.Recording fetch(GitSource source) {
    skipOutdated(source);
    List<Fetched> fetched = new ArrayList<>();
    for (GitRequest request : rows.toFetch(source.id(), MAX_FAILURES)) {
      fetch(source, request).ifPresent(head -> fetched.add(new Fetched(request, head)));
    }
    return updated -> fetched.forEach(one -> record(updated, one));
  }

  /** Leaves out what waits of closed requests and of former heads. */
  private void skipOutdated(GitSource source) {
    commits.waiting(source.id()).stream()
        .map(GitCommit::requestNo)
        .filter(number -> number > 0)
        .distinct()
        .filter(number -> rows.find(source.id(), number).filter(GitRequest::isRecorded).isEmpty())
        .forEach(
            number -> {
              commits.skipWaiting(source.id(), number);
              rows.notRecorded(source.id(), number);
            });
  }

  /** Fetches a head; empty if there is none that may be built. */
  private Optional<String> fetch(GitSource source, GitRequest request) {
    try {
      sources.fetch(
          source, List.of(new RefSpec("+" + request.reference() + ":" + request.localReference())));
      String head = head(source, request);
      if (!request.fork() || head.equals(request.head())) {
        return Optional.of(head);
      }
      rows.moved(
          request,
          head,
          "The head has moved from "
              + request.head()
              + " to "
              + head
              + " before it was fetched. Look at the new commits, and ask for the build again.");
    } catch (RemoteException e) {
      log.debug("Request {} of source {} cannot be fetched", request.number(), source.id(), e);
      rows.failed(request, e.text());
    } catch (IOException e) {
      log.warn("Request {} of source {} cannot be read", request.number(), source.id(), e);
      rows.failed(request, "The head cannot be read: " + e.getMessage() + ".");
    }
    return Optional.empty();
  }

  private String head(GitSource source, GitRequest request) throws IOException {
    try (History history = History.open(sources.copy(source.id()))) {
      return history
          .resolve(request.localReference())
          .orElseThrow(() -> new IOException(request.reference() + " is no commit"));
    }
  }

  private void record(GitSource source, Fetched fetched) {
    GitRequest request = fetched.request();
    try (History history = History.open(sources.copy(source.id()))) {
      History.Commit head = history.commit(fetched.head());
      Optional<String> branch = history.resolve(source.reference());
      Optional<History.Commit> base =
          branch.isEmpty() ? Optional.empty() : history.mergeBase(head.id(), branch.get());
      transaction.executeWithoutResult(status -> record(source, request, head, base));
    } catch (IOException | RuntimeException e) {
      log.warn("Request {} of source {} cannot be read", request.number(), source.id(), e);
      rows.failed(request, "The commits cannot be read: " + e.getMessage() + ".");
    }
  }

  private void record(
      GitSource source, GitRequest request, History.Commit head, Optional<History.Commit> base) {
    String problem = problem(source, head, base);
    // If the head has moved in the meantime, it is fetched again.
    if (!rows.recorded(request, head.id(), problem)) {
      return;
    }
    GitCommit known = commits.find(source.id(), request.number(), head.id()).orElse(null);
    if (known != null && !isAgain(request, head, known)) {
      return;
    }
    commits.skipWaiting(source.id(), request.number());
    if (problem != null || base.isEmpty()) {
      return;
    }
    String baseId = baseOf(source, request, base.get());
    if (known != null) {
      commits.delete(known.id());
    }
    commits.insert(
        source.id(),
        request.number(),
        false,
        head,
        commits.nextPosition(source.id(), request.number()),
        GitCommit.State.WAITING,
        baseId);
  }

  private static @Nullable String problem(
      GitSource source, History.Commit head, Optional<History.Commit> base) {
    if (base.isEmpty()) {
      return "The request has no commit in common with the branch "
          + source.branch()
          + ", so there is nothing to compare with. Rebase it onto the branch, and push it again.";
    }
    return base.get().id().equals(head.id())
        ? "The head "
            + head.id()
            + " is already part of the branch "
            + source.branch()
            + ", so there is nothing to compare. Push a commit to the request."
        : null;
  }

  /** Whether a known commit is built again: somebody asked, or a force-push brought it back. */
  private static boolean isAgain(GitRequest request, History.Commit head, GitCommit known) {
    return switch (known.state()) {
      case BUILDING -> known.mergeBase();
      case WAITING, SKIPPED -> true;
      case DONE, INVALID -> !head.id().equals(request.recordedHead());
    };
  }

  /** The commit to compare with; it is built for the request if it has no result. */
  private String baseOf(GitSource source, GitRequest request, History.Commit base) {
    Optional<GitCommit> ofBranch = commits.find(source.id(), 0, base.id()).filter(this::hasResult);
    if (ofBranch.isPresent()) {
      return ofBranch.get().id();
    }
    Optional<GitCommit> ofRequest = commits.find(source.id(), request.number(), base.id());
    if (ofRequest.filter(this::hasResult).isPresent()) {
      return ofRequest.get().id();
    }
    ofRequest.ifPresent(old -> commits.delete(old.id()));
    return commits.insert(
        source.id(),
        request.number(),
        true,
        base,
        commits.nextPosition(source.id(), request.number()),
        GitCommit.State.WAITING,
        null);
  }

  /** Whether a commit has a result or will get one. One that waits may still be left out. */
  private boolean hasResult(GitCommit commit) {
    return switch (commit.state()) {
      case BUILDING, INVALID -> true;
      case DONE -> commits.cells(commit.id()).stream().allMatch(cell -> cell.total() != null);
      case WAITING, SKIPPED -> false;
    };
  }
}
