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

/** The audit log: who changed or tried to change what. */
@Service
public class Audit {
  /**
   * Request attribute with the subject of the event; by default the subject is the request's URI.
   * Sign-in sets the user name.
   */
  public static final String SUBJECT = Audit.class.getName() + ".subject";

  private static final String FILTERED =
      " FROM audit_event WHERE actor = COALESCE(?, actor) AND action = COALESCE(?, action)";

  private static final Logger log = LoggerFactory.getLogger(Audit.class);

  private final JdbcClient jdbc;
  private final DiskSpace disk;
  private final Clock clock;
  private final AuditThrottle throttle = new AuditThrottle();

  Audit(JdbcClient jdbc, DiskSpace disk, Clock clock) {
    this.jdbc = jdbc;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * An audit event.
   *
   * @param actor a user, the owner of a token, an agent, or {@code -} if not authenticated
   * @param action the operationId of the request, or another name
   * @param subject what the action applies to
   * @param outcome {@code done}, or why it was rejected
   * @param address of the client
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
   * Records a rejected request. Of many rejections per minute from one address only the first few
   * are stored, and the number of the others, so that unauthenticated clients cannot fill the
   * database.
   */
  public void recordRejected(
      String actor, String action, String subject, String outcome, String address) {
    List<AuditThrottle.Summary> summaries = new ArrayList<>();
    boolean store =
        throttle.shouldStore(action, Addresses.group(address), clock.instant(), summaries);
    summaries.forEach(this::record);
    if (store) {
      record(actor, action, subject, outcome, address);
    }
  }

  /** Stores the numbers of rejections that were not stored one by one. */
  @Scheduled(fixedDelayString = "PT1M")
  void summarize() {
    throttle.removeExpired(clock.instant()).forEach(this::record);
  }

  private void record(AuditThrottle.Summary summary) {
    record(
        "-",
        summary.action(),
        "%d more within a minute".formatted(summary.count()),
        "refused",
        summary.address());
  }

  /** Whether a user signed in from an address since the given time. */
  public boolean hasSignedIn(String name, String address, Instant since) {
    return jdbc.sql(
                "SELECT COUNT(*) FROM audit_event WHERE actor = ? AND at_time > ?"
                    + " AND action IN ('signIn', 'openLink') AND outcome = 'done' AND address = ?")
            .params(name, utc(since), cut(address, 60))
            .query(Long.class)
            .single()
        > 0;
  }

  /** Records an event; while the disk is full, only in the server's log. */
  public void record(String actor, String action, String subject, String outcome, String address) {
    if (!disk.canWrite()) {
      log.warn(
          "Disk full, event not added to the audit log: {} {} {} {} {}",
          singleLine(cut(actor, 100)),
          singleLine(cut(action, 60)),
          singleLine(cut(subject, 400)),
          singleLine(cut(outcome, 200)),
          singleLine(cut(address, 60)));
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

  /** Events, newest first; null means any actor or action. */
  List<Event> list(@Nullable String actor, @Nullable String action, PageRequest page) {
    return jdbc.sql(
            "SELECT id, at_time, actor, action, subject, outcome, address"
                + FILTERED
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
    return jdbc.sql("SELECT COUNT(*)" + FILTERED).params(actor, action).query(Long.class).single();
  }

  /** Deletes events that are older than the given age. */
  public void deleteOlderThan(Duration age) {
    jdbc.sql("DELETE FROM audit_event WHERE at_time < ?")
        .param(utc(clock.instant().minus(age)))
        .update();
  }

  private static OffsetDateTime utc(Instant instant) {
    return instant.atOffset(ZoneOffset.UTC);
  }

  /** Prevents log injection by line breaks. */
  private static String singleLine(String text) {
    return text.replaceAll("\\p{Cntrl}", "?");
  }

  /** Fits the column; PostgreSQL does not store NUL characters. */
  private static String cut(String text, int maxLength) {
    String clean = text.replace('\0', '?');
    return clean.length() <= maxLength ? clean : clean.substring(0, maxLength);
  }
}
