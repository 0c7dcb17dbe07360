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
 * Reopens an H2 database that closed itself after a failed write. All old connections must be
 * closed first: if one of them is used or closed later, H2 removes the new database from its list
 * of open databases, and it cannot be opened again.
 */
final class DatabaseReopener implements SQLExceptionOverride {
  private static final Logger log = LoggerFactory.getLogger(DatabaseReopener.class);
  private static final Duration EVICTION_TIMEOUT = Duration.ofSeconds(30);
  private static final long EVICTION_POLL_MS = 20;
  private static final long RETRY_MS = 500;

  private final HikariDataSource pool;
  private final Runnable beforeOpening;
  private boolean reopening;

  DatabaseReopener(HikariDataSource pool, Runnable beforeOpening) {
    this.pool = pool;
    this.beforeOpening = beforeOpening;
    pool.setAllowPoolSuspension(true);
    pool.setExceptionOverride(this);
  }

  /** Called by the pool for each exception of a connection. */
  @java.lang.Override // Override is the return type here.
  public Override adjudicate(SQLException e) {
    if (!StorageFailure.isClosedH2(e)) {
      return Override.CONTINUE_EVICT;
    }
    begin(e);
    return Override.MUST_EVICT;
  }

  /**
   * Waits while the database is being reopened.
   *
   * @return false if it is not open when the timeout ends
   */
  synchronized boolean await(Duration timeout) throws InterruptedException {
    long end = System.nanoTime() + timeout.toNanos();
    while (reopening) {
      long leftMs = (end - System.nanoTime()) / 1_000_000;
      if (leftMs <= 0) {
        return false;
      }
      wait(leftMs);
    }
    return true;
  }

  private synchronized void begin(SQLException why) {
    if (reopening || pool.isClosed()) {
      return;
    }
    reopening = true;
    log.error("The database closed itself and is being reopened: {}", why.getMessage());
    Thread thread = new Thread(this::reopen, "database-reopener");
    thread.setDaemon(true);
    thread.start();
  }

  private void reopen() {
    try {
      while (!pool.isClosed() && !tryToOpen()) {
        Thread.sleep(RETRY_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        reopening = false;
        notifyAll();
      }
    }
  }

  private boolean tryToOpen() throws InterruptedException {
    evictConnections();
    beforeOpening.run();
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

  private void evictConnections() throws InterruptedException {
    HikariPoolMXBean connections = Objects.requireNonNull(pool.getHikariPoolMXBean());
    connections.suspendPool();
    try {
      long end = System.nanoTime() + EVICTION_TIMEOUT.toNanos();
      do {
        connections.softEvictConnections();
        Thread.sleep(EVICTION_POLL_MS);
      } while (connections.getTotalConnections() > 0 && System.nanoTime() < end);
    } finally {
      connections.resumePool();
    }
  }
}
