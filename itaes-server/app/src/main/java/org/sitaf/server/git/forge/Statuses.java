package org.sitaf.server.git.forge;

import java.io.IOException;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitEvent;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.commit.GitCommit;
import org.sitaf.server.git.source.ForgeProject;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.git.source.SourceRows;
import org.sitaf.server.storage.DiskSpace;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.beans.factory.DisposableBean;
import org.springframework.context.event.EventListener;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Service;
import org.springframework.transaction.event.TransactionalEventListener;

/**
 * Sends the statuses of commits: pending, then one final status. They are stored in the transaction
 * that changes the commit, and sent until the forge has them. Before a status is sent again, the
 * forge is asked whether it has it, so that a lost answer makes no second one.
 */
@Service
class Statuses implements DisposableBean {
  private static final Logger log = LoggerFactory.getLogger(Statuses.class);
  private static final int AT_ONCE = 8;
  private static final int BATCH = 50;
  private static final int MAX_ANSWER = 400;
  private static final Duration FIRST_DELAY = Duration.ofSeconds(1);
  private static final Duration MAX_DELAY = Duration.ofMinutes(10);
  private static final Duration GIVE_UP = Duration.ofDays(7);

  /** If a server dies while it sends, another one asks the forge after this time. */
  private static final Duration CLAIM = Duration.ofSeconds(30);

  private final JdbcClient jdbc;
  private final CommitRows commits;
  private final SourceRows sourceRows;
  private final GitSources sources;
  private final StatusTexts texts;
  private final ForgeClient client;
  private final DiskSpace disk;
  private final Clock clock;
  private final ExecutorService threads = Executors.newFixedThreadPool(AT_ONCE, Statuses::thread);

  /** Sources whose statuses are being sent; each forge delays only its own. */
  private final Set<String> sending = ConcurrentHashMap.newKeySet();

  Statuses(
      JdbcClient jdbc,
      CommitRows commits,
      SourceRows sourceRows,
      GitSources sources,
      StatusTexts texts,
      ForgeClient client,
      DiskSpace disk,
      Clock clock) {
    this.jdbc = jdbc;
    this.commits = commits;
    this.sourceRows = sourceRows;
    this.sources = sources;
    this.texts = texts;
    this.client = client;
    this.disk = disk;
    this.clock = clock;
  }

  private record Row(
      String id,
      String commitId,
      CommitStatus.Result result,
      String description,
      int tries,
      Instant created) {}

  private static Thread thread(Runnable task) {
    Thread thread = new Thread(task, "git-statuses");
    thread.setDaemon(true);
    return thread;
  }

  /** Within the transaction that changes the commit. */
  @EventListener
  void on(CommitEvent event) {
    GitCommit commit = commits.find(event.commitId()).orElseThrow();
    GitSource source = sourceRows.find(commit.sourceId()).orElseThrow();
    if (source.project() == null || !commit.isReported()) {
      return;
    }
    insert(commit, false, CommitStatus.Result.PENDING, StatusTexts.PENDING_DESCRIPTION);
    if (event instanceof CommitEvent.Ended) {
      StatusTexts.Summary summary = texts.summary(commit);
      insert(commit, true, summary.result(), summary.description());
    }
  }

  private void insert(
      GitCommit commit, boolean isFinal, CommitStatus.Result result, String description) {
    boolean known =
        jdbc.sql("SELECT COUNT(*) FROM git_status WHERE commit_id = ? AND is_final = ?")
                .params(commit.id(), isFinal)
                .query(Integer.class)
                .single()
            > 0;
    if (!known) {
      jdbc.sql(
              "INSERT INTO git_status (id, commit_id, is_final, result, description, state, tries,"
                  + " due, created) VALUES (?, ?, ?, ?, ?, 'WAITING', 0, ?, ?)")
          .params(
              UUID.randomUUID().toString(),
              commit.id(),
              isFinal,
              result.name(),
              description,
              utc(clock.instant()),
              utc(clock.instant()))
          .update();
    }
  }

  @TransactionalEventListener
  void afterCommit(CommitEvent event) {
    sendDue();
  }

  @Scheduled(fixedDelayString = "${sitaf.git.status-interval:2s}")
  void sendDue() {
    if (!disk.canWrite()) {
      return;
    }
    jdbc.sql(
            "SELECT DISTINCT c.source_id FROM git_status s JOIN git_commit c ON c.id = s.commit_id"
                + " WHERE s.state = 'WAITING' AND s.due <= ?")
        .param(utc(clock.instant()))
        .query(String.class)
        .list()
        .forEach(this::submit);
  }

  private void submit(String sourceId) {
    if (!sending.add(sourceId)) {
      return;
    }
    try {
      threads.execute(
          () -> {
            try {
              send(sourceId);
            } catch (RuntimeException e) {
              log.warn("The statuses of source {} cannot be sent; retrying", sourceId, e);
            } finally {
              sending.remove(sourceId);
            }
          });
    } catch (RejectedExecutionException e) {
      sending.remove(sourceId);
    }
  }

  /** A final status waits until the forge has the pending one. */
  private void send(String sourceId) {
    List<Row> due;
    do {
      due =
          jdbc.sql(
                  "SELECT s.id, s.commit_id, s.result, s.description, s.tries, s.created"
                      + " FROM git_status s JOIN git_commit c ON c.id = s.commit_id"
                      + " WHERE c.source_id = ? AND s.state = 'WAITING' AND s.due <= ?"
                      + " AND (s.is_final = FALSE OR NOT EXISTS (SELECT 1 FROM git_status p"
                      + " WHERE p.commit_id = s.commit_id AND p.is_final = FALSE"
                      + " AND p.state = 'WAITING')) ORDER BY s.created, s.is_final LIMIT "
                      + BATCH)
              .params(sourceId, utc(clock.instant()))
              .query(Statuses::row)
              .list();
      due.stream().filter(this::claim).forEach(this::send);
    } while (!due.isEmpty() && !threads.isShutdown());
  }

  /** Claims a status, so that only one of several servers sends it. */
  private boolean claim(Row row) {
    return jdbc.sql(
                "UPDATE git_status SET tries = tries + 1, due = ?"
                    + " WHERE id = ? AND tries = ? AND state = 'WAITING'")
            .params(utc(clock.instant().plus(CLAIM)), row.id(), row.tries())
            .update()
        == 1;
  }

  private void send(Row row) {
    GitCommit commit = commits.find(row.commitId()).orElse(null);
    GitSource source = commit == null ? null : sourceRows.find(commit.sourceId()).orElse(null);
    if (commit == null || source == null) {
      return;
    }
    ForgeProject project = source.project();
    String answer;
    boolean delivered = false;
    try {
      if (project == null) {
        throw new IOException("the forge was removed from the settings");
      }
      String token =
          sources
              .forgeToken(source)
              .orElseThrow(() -> new IOException("there is no token for the forge"));
      CommitStatus status =
          new CommitStatus(
              commit.sha(),
              row.result(),
              texts.context(source),
              row.description(),
              texts.page(source, commit));
      if (row.tries() == 0 || !client.has(project, token, status)) {
        client.send(project, token, status);
      }
      delivered = true;
      answer = "delivered";
    } catch (IOException | RequestException e) {
      answer = String.valueOf(e.getMessage());
    }
    store(row, delivered, answer);
  }

  private void store(Row row, boolean delivered, String answer) {
    boolean late = row.created().plus(GIVE_UP).isBefore(clock.instant());
    Duration delay = FIRST_DELAY.multipliedBy(1L << Math.min(row.tries(), 12));
    jdbc.sql("UPDATE git_status SET state = ?, due = ?, last_answer = ? WHERE id = ?")
        .params(
            delivered ? "DELIVERED" : late ? "GIVEN_UP" : "WAITING",
            utc(clock.instant().plus(delay.compareTo(MAX_DELAY) > 0 ? MAX_DELAY : delay)),
            answer.substring(0, Math.min(answer.length(), MAX_ANSWER)),
            row.id())
        .update();
  }

  private static Row row(ResultSet row, int index) throws SQLException {
    return new Row(
        row.getString(1),
        row.getString(2),
        CommitStatus.Result.valueOf(row.getString(3)),
        row.getString(4),
        row.getInt(5),
        row.getObject(6, OffsetDateTime.class).toInstant());
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  @Override
  public void destroy() {
    threads.shutdownNow();
  }
}
