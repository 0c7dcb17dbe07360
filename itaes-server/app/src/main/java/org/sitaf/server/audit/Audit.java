package org.sitaf.server.audit;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.network.Addresses;
import org.sitaf.server.storage.DiskSpace;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.data.domain.PageRequest;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Service;

/** The audit log: who changed what, and who tried. */
@Service
public class Audit {
  /**
   * The attribute of a request that says what it is about, where its address does not: the name in
   * an attempt to sign in.
   */
  public static final String SUBJECT = Audit.class.getName() + ".subject";

  private static final String WANTED =
      " FROM audit_event WHERE actor = COALESCE(?, actor) AND action = COALESCE(?, action)";

  private static final Logger log = LoggerFactory.getLogger(Audit.class);

  private final JdbcClient jdbc;
  private final DiskSpace disk;
  private final Clock clock;
  private final Refusals refusals = new Refusals();

  Audit(JdbcClient jdbc, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * Something that somebody did or tried.
   *
   * @param actor a person, the owner of a token, an agent, or a dash for nobody known
   * @param action as the interface names it
   * @param subject to what
   * @param outcome done, or why not
   * @param address from where
   */
  public record Event(
      long id,
      Instant at,
      String actor,
      String action,
      String subject,
      String outcome,
      String address) {}

  /**
   * Adds an attempt of somebody who is not known, or is not let in. Of many in a minute from one
   * address a few are kept, and the number of the others: strangers do not fill the database.
   */
  public void recordRefusal(
      String actor, String action, String subject, String outcome, String address) {
    List<Refusals.Summary> summaries = new ArrayList<>();
    boolean kept = refusals.isKept(action, Addresses.group(address), clock.instant(), summaries);
    summaries.forEach(this::record);
    if (kept) {
      record(actor, action, subject, outcome, address);
    }
  }

  /** What was counted and not kept, once its minute is over. */
  @Scheduled(fixedDelayString = "PT1M")
  void summarize() {
    refusals.over(clock.instant()).forEach(this::record);
  }

  private void record(Refusals.Summary summary) {
    record(
        "-",
        summary.action(),
        "%d more within a minute".formatted(summary.count()),
        "refused",
        summary.address());
  }

  /** Whether somebody of this name has signed in from an address since then. */
  public boolean hasSignedIn(String name, String address, Instant since) {
    return jdbc.sql(
                "SELECT COUNT(*) FROM audit_event WHERE actor = ? AND at_time > ?"
                    + " AND action IN ('signIn', 'openLink') AND outcome = 'done' AND address = ?")
            .params(name, utc(since), cut(address, 60))
            .query(Long.class)
            .single()
        > 0;
  }

  /** Adds an event; while there is no room for it, only to the server's own log. */
  public void record(String actor, String action, String subject, String outcome, String address) {
    if (!disk.canWrite()) {
      log.warn(
          "No room in the audit log: {} {} {} {} {}",
          plain(cut(actor, 100)),
          plain(cut(action, 60)),
          plain(cut(subject, 400)),
          plain(cut(outcome, 200)),
          plain(cut(address, 60)));
      return;
    }
    jdbc.sql(
            "INSERT INTO audit_event (at_time, actor, action, subject, outcome, address)"
                + " VALUES (?, ?, ?, ?, ?, ?)")
        .params(
            utc(clock.instant()),
            cut(actor, 100),
            cut(action, 60),
            cut(subject, 400),
            cut(outcome, 200),
            cut(address, 60))
        .update();
  }

  /** Events, the latest first; null for those of every actor or action. */
  List<Event> list(@Nullable String actor, @Nullable String action, PageRequest page) {
    return jdbc.sql(
            "SELECT id, at_time, actor, action, subject, outcome, address"
                + WANTED
                + " ORDER BY at_time DESC, id DESC LIMIT ? OFFSET ?")
        .params(actor, action, page.getPageSize(), page.getOffset())
        .query(
            (row, index) ->
                new Event(
                    row.getLong(1),
                    row.getObject(2, OffsetDateTime.class).toInstant(),
                    row.getString(3),
                    row.getString(4),
                    row.getString(5),
                    row.getString(6),
                    row.getString(7)))
        .list();
  }

  long count(@Nullable String actor, @Nullable String action) {
    return jdbc.sql("SELECT COUNT(*)" + WANTED).params(actor, action).query(Long.class).single();
  }

  /** Drops what is older. */
  public void forget(Duration olderThan) {
    jdbc.sql("DELETE FROM audit_event WHERE at_time < ?")
        .param(utc(clock.instant().minus(olderThan)))
        .update();
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  /** In one line of a log, whatever strangers send. */
  private static String plain(String text) {
    return text.replaceAll("\\p{Cntrl}", "?");
  }

  /** Of what strangers send, too; a NUL is no text for PostgreSQL. */
  private static String cut(String text, int most) {
    String clean = text.replace('\0', '?');
    return clean.length() <= most ? clean : clean.substring(0, most);
  }
}
