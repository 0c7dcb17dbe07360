package org.sitaf.server.storage;

import com.zaxxer.hikari.HikariDataSource;
import com.zaxxer.hikari.HikariPoolMXBean;
import com.zaxxer.hikari.SQLExceptionOverride;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.Objects;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Opens an H2 database anew that has closed itself after a failed write. All connections to it have
 * to be gone first: each that is used or closed later would take the new one from H2's list of open
 * databases, and nobody could open it again.
 */
final class Reopening implements SQLExceptionOverride {
  private static final Logger log = LoggerFactory.getLogger(Reopening.class);
  private static final Duration LETTING_GO = Duration.ofSeconds(30);
  private static final long LOOK_MS = 20;
  private static final long PAUSE_MS = 500;

  private final HikariDataSource pool;
  private boolean away;

  Reopening(HikariDataSource pool) {
    this.pool = pool;
    pool.setAllowPoolSuspension(true);
    pool.setExceptionOverride(this);
  }

  /** Is shown each exception that a connection of the pool throws. */
  @java.lang.Override // Override is an answer here.
  public Override adjudicate(SQLException e) {
    if (!StorageFailure.isClosedH2(e)) {
      return Override.CONTINUE_EVICT;
    }
    begin(e);
    return Override.MUST_EVICT;
  }

  /**
   * Waits while the database is opened anew.
   *
   * @return false when it is still away after that time
   */
  synchronized boolean await(Duration atMost) throws InterruptedException {
    long end = System.nanoTime() + atMost.toNanos();
    while (away) {
      long leftMs = (end - System.nanoTime()) / 1_000_000;
      if (leftMs <= 0) {
        return false;
      }
      wait(leftMs);
    }
    return true;
  }

  private synchronized void begin(SQLException why) {
    if (away || pool.isClosed()) {
      return;
    }
    away = true;
    log.error("The database has closed itself and is opened anew: {}", why.getMessage());
    Thread thread = new Thread(this::work, "database-reopening");
    thread.setDaemon(true);
    thread.start();
  }

  private void work() {
    try {
      while (!pool.isClosed() && !isOpenAgain()) {
        Thread.sleep(PAUSE_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        away = false;
        notifyAll();
      }
    }
  }

  private boolean isOpenAgain() throws InterruptedException {
    letGoOfAll();
    try (Connection connection = pool.getConnection();
        Statement statement = connection.createStatement()) {
      statement.execute("SELECT COUNT(*) FROM \"flyway_schema_history\"");
      log.warn("The database is open again");
      return true;
    } catch (SQLException e) {
      log.warn("The database cannot be opened yet: {}", e.getMessage());
      return false;
    }
  }

  private void letGoOfAll() throws InterruptedException {
    HikariPoolMXBean connections = Objects.requireNonNull(pool.getHikariPoolMXBean());
    connections.suspendPool();
    try {
      long end = System.nanoTime() + LETTING_GO.toNanos();
      do {
        connections.softEvictConnections();
        Thread.sleep(LOOK_MS);
      } while (connections.getTotalConnections() > 0 && System.nanoTime() < end);
    } finally {
      connections.resumePool();
    }
  }
}
