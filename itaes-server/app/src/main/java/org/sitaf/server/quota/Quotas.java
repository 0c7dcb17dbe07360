package org.sitaf.server.quota;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.access.Caller;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.LimitSettings;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/**
 * Holds what callers store against what they may. The command that started the server on its own
 * machine, and schedules, may anything.
 */
@Service
public class Quotas {
  /** What a person has besides one activity, each content once. */
  private static final String CONTENTS =
      "SELECT f.sha256, f.size FROM workspace_file f JOIN workspace_owner o"
          + " ON o.workspace_id = f.workspace_id"
          + " WHERE o.person_id = :person AND f.workspace_id <> :besides"
          + " UNION SELECT f.sha256, f.size FROM build_file f JOIN build_owner o"
          + " ON o.build_id = f.build_id WHERE o.person_id = :person";

  private static final String ACTIVITIES =
      "SELECT COUNT(*) FROM workspace_owner WHERE person_id = :person";
  private static final String SUITES = "SELECT COUNT(*) FROM suite_owner WHERE person_id = :person";
  private static final String OPEN_BUILDS =
      "SELECT COUNT(*) FROM build b JOIN build_owner o ON o.build_id = b.id"
          + " WHERE o.person_id = :person AND b.parent_id IS NULL"
          + " AND b.state NOT IN ('DONE', 'FAILED', 'CANCELLED')";
  private static final String NONE = "";
  private static final int MIB_SHIFT = 20;

  private final JdbcClient jdbc;
  private final LimitSettings limits;
  private final Map<String, Object> busy = new ConcurrentHashMap<>();

  Quotas(JdbcClient jdbc, LimitSettings limits) {
    this.jdbc = jdbc;
    this.limits = limits;
  }

  /**
   * Stores files of the present caller, of whom nobody else stores any meanwhile.
   *
   * @param activityId in whose place they come; null for a new one
   * @throws Refusal when they are more than the caller may have
   */
  public <T> T storing(FileTree files, @Nullable String activityId, Supplier<T> store) {
    Optional<String> person = person();
    if (person.isEmpty()) {
      return store.get();
    }
    synchronized (busy.computeIfAbsent(person.get(), key -> new Object())) {
      if (activityId == null) {
        require(person.get(), "activities", ACTIVITIES, limits.activities());
      }
      requireRoom(person.get(), files, activityId == null ? NONE : activityId);
      return store.get();
    }
  }

  /**
   * Makes sure that the present caller may have another suite.
   *
   * @param size of its document, in bytes
   * @throws Refusal when not
   */
  public void requireSuite(long size) {
    person()
        .ifPresent(
            person -> {
              require(person, "suites", SUITES, limits.suites());
              requireRoom(person, sum(contents(person, NONE)), size);
            });
  }

  /**
   * Makes sure that the present caller may have another build under way.
   *
   * @throws Refusal when not
   */
  public void requireBuild(FileTree files) {
    person()
        .ifPresent(
            person -> {
              require(person, "builds that are not over", OPEN_BUILDS, limits.openBuilds());
              requireRoom(person, files, NONE);
            });
  }

  /** The activity counts for the present caller from now on. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void ownActivity(String id) {
    jdbc.sql("DELETE FROM workspace_owner WHERE workspace_id = ?").param(id).update();
    person()
        .ifPresent(
            person ->
                jdbc.sql("INSERT INTO workspace_owner (workspace_id, person_id) VALUES (?, ?)")
                    .params(id, person)
                    .update());
  }

  /** The suite counts for the present caller. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void ownSuite(String id, long size) {
    person()
        .ifPresent(
            person ->
                jdbc.sql("INSERT INTO suite_owner (suite_id, person_id, size) VALUES (?, ?, ?)")
                    .params(id, person, size)
                    .update());
  }

  /** The build counts for the present caller. */
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

  /**
   * Sets what a person's files may take.
   *
   * @param mib null for what the server's settings say
   */
  void set(String person, @Nullable Long mib) {
    if (mib != null && (mib < 0 || mib > Long.MAX_VALUE >> MIB_SHIFT)) {
      throw Refusal.malformed("mib: 0 or more, or null for the server's own setting.");
    }
    jdbc.sql("UPDATE person SET quota_mib = ? WHERE id = ?").params(mib, person).update();
  }

  private void requireRoom(String person, FileTree files, String besides) {
    Map<String, Long> all = contents(person, besides);
    long before = sum(all);
    for (String path : files.paths()) {
      byte[] content = files.content(path).orElseThrow();
      all.put(StoredFiles.sha256(content), (long) content.length);
    }
    requireRoom(person, before, sum(all) - before);
  }

  private void requireRoom(String person, long before, long more) {
    long used = before + suites(person);
    long allowed = allowed(person);
    if (more > 0 && used + more > allowed) {
      throw Refusal.quota(
          ("It takes %d KiB more, and you use %d MiB of the %d MiB that you may. Delete activities"
                  + " that are not needed, or ask an administrator for more.")
              .formatted((more >> 10) + 1, used >> MIB_SHIFT, allowed >> MIB_SHIFT));
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

  private void require(String person, String what, String query, int most) {
    int present = count(person, query);
    if (present >= most) {
      throw Refusal.conflict(
          "You have %d %s, and may have %d; delete some, or wait for their end."
              .formatted(present, what, most));
    }
  }

  private int count(String person, String query) {
    return jdbc.sql(query).param("person", person).query(Integer.class).single();
  }

  private Map<String, Long> contents(String person, String besides) {
    Map<String, Long> contents = new HashMap<>();
    jdbc.sql(CONTENTS)
        .param("person", person)
        .param("besides", besides)
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
