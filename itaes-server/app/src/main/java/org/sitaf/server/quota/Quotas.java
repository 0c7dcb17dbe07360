package org.sitaf.server.quota;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.access.Caller;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.settings.LimitSettings;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/**
 * Enforces users' quotas. The launcher, which started the server on the same machine, and schedules
 * have no quotas.
 */
@Service
public class Quotas {
  /** Distinct contents of a user's activities, except one, and of the user's builds. */
  private static final String CONTENTS =
      "SELECT f.sha256, f.size FROM activity_file f JOIN activity_owner o"
          + " ON o.activity_id = f.activity_id"
          + " WHERE o.person_id = :person AND f.activity_id <> :except"
          + " UNION SELECT f.sha256, f.size FROM build_file f JOIN build_owner o"
          + " ON o.build_id = f.build_id WHERE o.person_id = :person";

  private static final String ACTIVITIES =
      "SELECT COUNT(*) FROM activity_owner WHERE person_id = :person";
  private static final String SUITES = "SELECT COUNT(*) FROM suite_owner WHERE person_id = :person";
  private static final String OPEN_BUILDS =
      "SELECT COUNT(*) FROM build b JOIN build_owner o ON o.build_id = b.id"
          + " WHERE o.person_id = :person AND b.parent_id IS NULL"
          + " AND b.state NOT IN ('DONE', 'FAILED', 'CANCELLED')";
  private static final String NONE = "";
  private static final int MIB_SHIFT = 20;

  private final JdbcClient jdbc;
  private final LimitSettings limits;
  private final Map<String, Object> locks = new ConcurrentHashMap<>();

  Quotas(JdbcClient jdbc, LimitSettings limits) {
    this.jdbc = jdbc;
    this.limits = limits;
  }

  /**
   * Stores files of the current caller if the quota allows it. Calls of the same user run one after
   * the other.
   *
   * @param activityId the activity whose files they replace; null for a new one
   * @throws RequestException if the files exceed the caller's quota
   */
  public <T> T storing(FileTree files, @Nullable String activityId, Supplier<T> store) {
    Optional<String> person = person();
    if (person.isEmpty()) {
      return store.get();
    }
    synchronized (locks.computeIfAbsent(person.get(), key -> new Object())) {
      if (activityId == null) {
        require(person.get(), "activities", ACTIVITIES, limits.activities());
      }
      requireSpace(person.get(), files, activityId == null ? NONE : activityId);
      return store.get();
    }
  }

  /**
   * Checks that the current caller can store another suite.
   *
   * @param size of its document, in bytes
   * @throws RequestException if the quota is exceeded
   */
  public void requireSuite(long size) {
    person()
        .ifPresent(
            person -> {
              require(person, "suites", SUITES, limits.suites());
              requireSpace(person, sum(contents(person, NONE)), size);
            });
  }

  /**
   * Checks that the current caller can start another build.
   *
   * @throws RequestException if the quota is exceeded
   */
  public void requireBuild(FileTree files) {
    person()
        .ifPresent(
            person -> {
              require(person, "unfinished builds", OPEN_BUILDS, limits.openBuilds());
              requireSpace(person, files, NONE);
            });
  }

  /** Makes the current caller the owner of an activity. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void ownActivity(String id) {
    jdbc.sql("DELETE FROM activity_owner WHERE activity_id = ?").param(id).update();
    person()
        .ifPresent(
            person ->
                jdbc.sql("INSERT INTO activity_owner (activity_id, person_id) VALUES (?, ?)")
                    .params(id, person)
                    .update());
  }

  /** Makes the current caller the owner of a suite. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void ownSuite(String id, long size) {
    person()
        .ifPresent(
            person ->
                jdbc.sql("INSERT INTO suite_owner (suite_id, person_id, size) VALUES (?, ?, ?)")
                    .params(id, person, size)
                    .update());
  }

  /** Makes the current caller the owner of a build. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void ownBuild(String id) {
    person()
        .ifPresent(
            person ->
                jdbc.sql("INSERT INTO build_owner (build_id, person_id) VALUES (?, ?)")
                    .params(id, person)
                    .update());
  }

  Usage usage(String person) {
    return new Usage(
        sum(contents(person, NONE)) + suites(person),
        allowed(person),
        count(person, ACTIVITIES),
        limits.activities(),
        count(person, SUITES),
        limits.suites(),
        count(person, OPEN_BUILDS),
        limits.openBuilds());
  }

  /** Sets the quota of a user's files; null for the server's default. */
  void set(String person, @Nullable Long mib) {
    if (mib != null && (mib < 0 || mib > Long.MAX_VALUE >> MIB_SHIFT)) {
      throw RequestException.malformed("mib: must be 0 or more, or null for the server's default.");
    }
    jdbc.sql("UPDATE person SET quota_mib = ? WHERE id = ?").params(mib, person).update();
  }

  private void requireSpace(String person, FileTree files, String except) {
    Map<String, Long> contents = contents(person, except);
    long before = sum(contents);
    for (String path : files.paths()) {
      byte[] content = files.content(path).orElseThrow();
      contents.put(StoredFiles.sha256(content), (long) content.length);
    }
    requireSpace(person, before, sum(contents) - before);
  }

  private void requireSpace(String person, long before, long additional) {
    long used = before + suites(person);
    long allowed = allowed(person);
    if (additional > 0 && used + additional > allowed) {
      throw RequestException.quota(
          ("This needs %d KiB, and you use %d MiB of your %d MiB. Delete activities that you no"
                  + " longer need, or ask an administrator for a larger quota.")
              .formatted((additional >> 10) + 1, used >> MIB_SHIFT, allowed >> MIB_SHIFT));
    }
  }

  private long suites(String person) {
    return jdbc.sql("SELECT COALESCE(SUM(size), 0) FROM suite_owner WHERE person_id = ?")
        .param(person)
        .query(Long.class)
        .single();
  }

  private static long sum(Map<String, Long> contents) {
    return contents.values().stream().mapToLong(Long::longValue).sum();
  }

  private void require(String person, String what, String query, int max) {
    int present = count(person, query);
    if (present >= max) {
      throw RequestException.conflict(
          "You have %d of at most %d %s; delete some, or wait until they end."
              .formatted(present, max, what));
    }
  }

  private int count(String person, String query) {
    return jdbc.sql(query).param("person", person).query(Integer.class).single();
  }

  private Map<String, Long> contents(String person, String except) {
    Map<String, Long> contents = new HashMap<>();
    jdbc.sql(CONTENTS)
        .param("person", person)
        .param("except", except)
        .query((row, index) -> contents.put(row.getString(1), row.getLong(2)))
        .list();
    return contents;
  }

  private long allowed(String person) {
    return jdbc.sql("SELECT quota_mib FROM person WHERE id = ? AND quota_mib IS NOT NULL")
        .param(person)
        .query(Long.class)
        .optional()
        .map(mib -> mib << MIB_SHIFT)
        .orElse(limits.quota().toBytes());
  }

  private static Optional<String> person() {
    return Caller.isKnown() ? Optional.ofNullable(Caller.current().personId()) : Optional.empty();
  }
}
