package org.sitaf.server.git.request;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.Fetches;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.git.source.SourceChanged;
import org.sitaf.server.git.source.SourceRows;
import org.springframework.context.event.EventListener;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.data.domain.PageRequest;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Pull and merge requests into the branches of activities. A forge reports them; their heads are
 * fetched and built, those of forks only after somebody asked for exactly this head.
 */
@Service
public class GitRequests {
  private final RequestRows rows;
  private final GitSources sources;
  private final SourceRows sourceRows;
  private final CommitRows commits;
  private final Fetches fetches;
  private final TransactionTemplate transaction;

  GitRequests(
      RequestRows rows,
      GitSources sources,
      SourceRows sourceRows,
      CommitRows commits,
      Fetches fetches,
      TransactionTemplate transaction) {
    this.rows = rows;
    this.sources = sources;
    this.sourceRows = sourceRows;
    this.commits = commits;
    this.fetches = fetches;
    this.transaction = transaction;
  }

  /** Takes what a forge reports; requests into other branches and repositories are ignored. */
  public void report(GitSource source, ReportedRequest reported) {
    if (!reported.concerns(source)) {
      return;
    }
    boolean open = reported.open() && reported.branch().equals(source.branch());
    if (!open && rows.find(source.id(), reported.number()).isEmpty()) {
      return;
    }
    rows.report(source, reported, open ? GitRequest.State.OPEN : GitRequest.State.CLOSED);
    fetches.requestBuilds(source.id());
  }

  /**
   * Fetches and builds the head of a request, also of one from a fork.
   *
   * @param head that the caller has looked at
   * @throws RequestException if the request has another head by now, or is closed or not known
   */
  GitRequest build(String activityId, int number, String head) {
    GitSource source = sources.require(activityId);
    GitRequest request = require(source, number);
    if (!rows.ask(source.id(), number, head, Caller.currentName())) {
      request = require(source, number);
      throw RequestException.conflict(
          request.isOpen()
              ? "The head of request "
                  + number
                  + " is now "
                  + request.head()
                  + ". Look at its commits, and ask for this head."
              : "Request " + number + " is closed. Reopen it at the forge first.");
    }
    fetches.requestBuilds(source.id());
    return require(source, number);
  }

  /** A request of an activity. */
  GitRequest require(String activityId, int number) {
    return require(sources.require(activityId), number);
  }

  private GitRequest require(GitSource source, int number) {
    return rows.find(source.id(), number)
        .orElseThrow(
            () ->
                RequestException.notFound(
                    "The forge has reported no request "
                        + number
                        + " into the branch "
                        + source.branch()
                        + ". Add the event of pull or merge requests to its webhook, then push to"
                        + " the request or reopen it."));
  }

  /** A page of the requests of an activity, and the number of all. */
  record Found(List<GitRequest> requests, long total) {}

  /**
   * Lists requests.
   *
   * @param state null for any
   */
  Found list(String activityId, GitRequest.@Nullable State state, PageRequest page) {
    String source = sources.require(activityId).id();
    return new Found(
        rows.list(source, state, page.getPageSize(), page.getOffset()), rows.count(source, state));
  }

  /** Forgets requests into a branch or a repository that the source no longer has. */
  @EventListener
  @Order(Ordered.HIGHEST_PRECEDENCE)
  void on(SourceChanged change) {
    Optional<GitSource> source = sourceRows.find(change.sourceId());
    source.ifPresent(
        found ->
            rows.ofOtherBranches(found)
                .forEach(
                    number ->
                        transaction.executeWithoutResult(
                            status -> {
                              commits.deleteRequest(found.id(), number);
                              rows.delete(found.id(), number);
                            })));
  }
}
