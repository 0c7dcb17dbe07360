package org.sitaf.server.git.bisection;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Clock;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.server.git.source.GitSource;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/**
 * Searches in the database. Several servers can work on one: each change expects that the search
 * still runs, and that nobody else has made it.
 */
@Repository
class BisectionRows {
  private static final int MAX_PROBLEM = 3900;
  private static final int MAX_REASON = 1000;
  private static final int MAX_CRITERION = 2000;
  private static final String COLUMNS =
      "SELECT source_id, bisection_no, url, branch, folder, good, bad, kind, case_no, output,"
          + " criterion, state, problem, asked_by, created, ended FROM git_bisection ";
  private static final String ONE = "WHERE source_id = ? AND bisection_no = ?";

  private final JdbcClient jdbc;
  private final Clock clock;

  BisectionRows(JdbcClient jdbc, Clock clock) {
    this.jdbc = jdbc;
    this.clock = clock;
  }

  Optional<GitBisection> find(String sourceId, int number) {
    return whole(
            jdbc.sql(COLUMNS + ONE).params(sourceId, number).query(BisectionRows::bisection).list())
        .stream()
        .findFirst();
  }

  /** Searches of a source, the newest first. */
  List<GitBisection> list(String sourceId, int size, long offset) {
    return whole(
        jdbc.sql(COLUMNS + "WHERE source_id = ? ORDER BY bisection_no DESC LIMIT ? OFFSET ?")
            .params(sourceId, size, offset)
            .query(BisectionRows::bisection)
            .list());
  }

  long count(String sourceId) {
    return jdbc.sql("SELECT COUNT(*) FROM git_bisection WHERE source_id = ?")
        .param(sourceId)
        .query(Long.class)
        .single();
  }

  /** All searches that run. */
  List<GitBisection> running() {
    return whole(
        jdbc.sql(COLUMNS + "WHERE running_source IS NOT NULL ORDER BY created")
            .query(BisectionRows::bisection)
            .list());
  }

  /** The number of the search of a source that runs. */
  Optional<Integer> running(String sourceId) {
    return jdbc.sql("SELECT bisection_no FROM git_bisection WHERE running_source = ?")
        .param(sourceId)
        .query(Integer.class)
        .optional();
  }

  /** Locks a source, so that nobody else begins a search of it. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void lock(String sourceId) {
    var unused =
        jdbc.sql("SELECT id FROM git_source WHERE id = ? FOR UPDATE")
            .param(sourceId)
            .query(String.class)
            .optional();
  }

  /** Begins a search, and returns its number. */
  @Transactional(propagation = Propagation.MANDATORY)
  public int insert(
      GitSource source,
      String good,
      String bad,
      GitBisection.Wanted wanted,
      String criterion,
      String askedBy,
      List<GitBisection.Model> models,
      List<GitBisection.Commit> commits) {
    int number =
        jdbc.sql("SELECT COALESCE(MAX(bisection_no), 0) FROM git_bisection WHERE source_id = ?")
                .param(source.id())
                .query(Integer.class)
                .single()
            + 1;
    jdbc.sql(
            "INSERT INTO git_bisection (source_id, bisection_no, running_source, url, branch,"
                + " folder, good, bad, kind, case_no, output, criterion, state, asked_by, created)"
                + " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 'RUNNING', ?, ?)")
        .params(
            source.id(),
            number,
            source.id(),
            source.url(),
            source.branch(),
            source.folder(),
            good,
            bad,
            wanted.kind().name(),
            wanted.caseNo(),
            wanted.output(),
            shortened(criterion, MAX_CRITERION),
            askedBy,
            now())
        .update();
    for (int i = 0; i < models.size(); i++) {
      GitBisection.Model model = models.get(i);
      jdbc.sql(
              "INSERT INTO git_bisection_model (source_id, bisection_no, position, model,"
                  + " good_build, bad_build) VALUES (?, ?, ?, ?, ?, ?)")
          .params(source.id(), number, i, model.name(), model.goodBuild(), model.badBuild())
          .update();
    }
    for (GitBisection.Commit commit : commits) {
      jdbc.sql(
              "INSERT INTO git_bisection_commit (source_id, bisection_no, position, sha, subject,"
                  + " author, authored) VALUES (?, ?, ?, ?, ?, ?, ?)")
          .params(
              source.id(),
              number,
              commit.position(),
              commit.sha(),
              commit.subject(),
              commit.author(),
              commit.authored().atOffset(ZoneOffset.UTC))
          .update();
    }
    return number;
  }

  /**
   * Locks a search until the end of the transaction.
   *
   * @return false if it has ended
   */
  @Transactional(propagation = Propagation.MANDATORY)
  public boolean lockRunning(GitBisection search) {
    return jdbc.sql(
            "SELECT bisection_no FROM git_bisection " + ONE + " AND state = 'RUNNING' FOR UPDATE")
        .params(search.sourceId(), search.number())
        .query(Integer.class)
        .optional()
        .isPresent();
  }

  /**
   * Stores the test of a commit.
   *
   * @return false if the commit was tested before, or the search has ended
   */
  boolean tested(GitBisection search, int position, int testNo, Outcome outcome, String reason) {
    return jdbc.sql(
                "UPDATE git_bisection_commit SET outcome = ?, reason = ?, test_no = ? "
                    + ONE
                    + " AND position = ? AND outcome IS NULL AND EXISTS (SELECT 1 FROM"
                    + " git_bisection b WHERE b.source_id = git_bisection_commit.source_id"
                    + " AND b.bisection_no = git_bisection_commit.bisection_no"
                    + " AND b.state = 'RUNNING')")
            .params(
                outcome.name(),
                reason.isEmpty() ? null : shortened(reason, MAX_REASON),
                testNo,
                search.sourceId(),
                search.number(),
                position)
            .update()
        == 1;
  }

  /**
   * Ends a search.
   *
   * @return false if it has ended before
   */
  boolean end(GitBisection search, GitBisection.State state, @Nullable String problem) {
    return jdbc.sql(
                "UPDATE git_bisection SET state = ?, problem = ?, ended = ?, running_source = NULL "
                    + ONE
                    + " AND state = 'RUNNING'")
            .params(
                state.name(),
                problem == null ? null : shortened(problem, MAX_PROBLEM),
                now(),
                search.sourceId(),
                search.number())
            .update()
        == 1;
  }

  /** The unfinished builds that were made for it. */
  List<String> unfinishedBuilds(GitBisection search) {
    return jdbc.sql(
            "SELECT l.build_id FROM git_cell l JOIN git_commit c ON c.id = l.commit_id"
                + " JOIN build b ON b.id = l.build_id WHERE c.source_id = ? AND c.request_no = ?"
                + " AND l.taken_from IS NULL AND b.finished IS NULL")
        .params(search.sourceId(), search.requestNo())
        .query(String.class)
        .list();
  }

  private List<GitBisection> whole(List<GitBisection> found) {
    Map<String, List<GitBisection>> bySource = new HashMap<>();
    found.forEach(f -> bySource.computeIfAbsent(f.sourceId(), id -> new ArrayList<>()).add(f));
    Map<Key, List<GitBisection.Model>> models = new HashMap<>();
    Map<Key, List<GitBisection.Commit>> commits = new HashMap<>();
    bySource.forEach(
        (source, searches) -> {
          List<Integer> numbers = searches.stream().map(GitBisection::number).toList();
          parts("git_bisection_model", "model, good_build, bad_build", source, numbers)
              .query(
                  row -> {
                    models
                        .computeIfAbsent(Key.of(row), key -> new ArrayList<>())
                        .add(
                            new GitBisection.Model(
                                row.getString(3), row.getString(4), row.getString(5)));
                  });
          parts(
                  "git_bisection_commit",
                  "position, sha, subject, author, authored, outcome, reason, test_no",
                  source,
                  numbers)
              .query(
                  row -> {
                    commits.computeIfAbsent(Key.of(row), key -> new ArrayList<>()).add(commit(row));
                  });
        });
    return found.stream()
        .map(
            f -> {
              Key key = new Key(f.sourceId(), f.number());
              return with(
                  f, models.getOrDefault(key, List.of()), commits.getOrDefault(key, List.of()));
            })
        .toList();
  }

  private record Key(String sourceId, int number) {
    static Key of(ResultSet row) throws SQLException {
      return new Key(row.getString(1), row.getInt(2));
    }
  }

  private JdbcClient.StatementSpec parts(
      String table, String columns, String sourceId, List<Integer> numbers) {
    return jdbc.sql(
            "SELECT source_id, bisection_no, "
                + columns
                + " FROM "
                + table
                + " WHERE source_id = :source AND bisection_no IN (:numbers)"
                + " ORDER BY bisection_no, position")
        .param("source", sourceId)
        .param("numbers", numbers);
  }

  private static GitBisection with(
      GitBisection found, List<GitBisection.Model> models, List<GitBisection.Commit> commits) {
    return new GitBisection(
        found.sourceId(),
        found.number(),
        found.url(),
        found.branch(),
        found.folder(),
        found.good(),
        found.bad(),
        found.wanted(),
        found.criterion(),
        found.state(),
        found.problem(),
        found.askedBy(),
        found.created(),
        found.ended(),
        models,
        commits);
  }

  private static GitBisection bisection(ResultSet row, int index) throws SQLException {
    OffsetDateTime ended = row.getObject(16, OffsetDateTime.class);
    return new GitBisection(
        row.getString(1),
        row.getInt(2),
        row.getString(3),
        row.getString(4),
        row.getString(5),
        row.getString(6),
        row.getString(7),
        new GitBisection.Wanted(
            GitBisection.Kind.valueOf(row.getString(8)), number(row, 9), row.getString(10)),
        row.getString(11),
        GitBisection.State.valueOf(row.getString(12)),
        row.getString(13),
        row.getString(14),
        row.getObject(15, OffsetDateTime.class).toInstant(),
        ended == null ? null : ended.toInstant(),
        List.of(),
        List.of());
  }

  private static GitBisection.Commit commit(ResultSet row) throws SQLException {
    String outcome = row.getString(8);
    return new GitBisection.Commit(
        row.getInt(3),
        row.getString(4),
        row.getString(5),
        row.getString(6),
        row.getObject(7, OffsetDateTime.class).toInstant(),
        outcome == null ? null : Outcome.valueOf(outcome),
        row.getString(9),
        number(row, 10));
  }

  private static @Nullable Integer number(ResultSet row, int column) throws SQLException {
    int value = row.getInt(column);
    return row.wasNull() ? null : value;
  }

  /** PostgreSQL cannot store NUL characters, which messages of components may have. */
  private static String shortened(String text, int max) {
    String clean = text.replace('\0', ' ');
    return clean.length() <= max ? clean : clean.substring(0, max - 1) + "…";
  }

  private OffsetDateTime now() {
    return clock.instant().atOffset(ZoneOffset.UTC);
  }
}
